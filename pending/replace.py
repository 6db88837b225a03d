"""Replacements in the files of a tree, for the scripts of edits beside this."""


def sub(path, *pairs):
    """Each (old, new) once, in this order; stops where the old text is not found."""
    text = open(path).read()
    for old, new in pairs:
        assert old in text, (path, old)
        text = text.replace(old, new, 1)
    open(path, 'w').write(text)
