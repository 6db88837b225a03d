"""Checks by html.parser that a page is well-formed and stands alone."""
import base64
import hashlib
import html.parser
import re

VOID = {'meta', 'input', 'br', 'link', 'img', 'hr'}
# Elements that load or run something from elsewhere or from a program's text.
FORBIDDEN_TAGS = {'link', 'img', 'iframe', 'object', 'embed', 'base', 'audio', 'video', 'source'}


class Page(html.parser.HTMLParser):
    """Collects every element with its attributes and text; `faults` lists what is not well-formed."""

    def __init__(self, text):
        super().__init__()
        self.open, self.faults, self.elements = [], [], []
        self.ids, self.links, self.scripts, self.policy = set(), [], [], ''
        self.feed(text)
        self.close()
        self.faults += [f'<{element["tag"]}> is never closed' for element in self.open]

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if len(values) != len(attributes):
            self.faults.append(f'<{tag}> names an attribute twice: {attributes}')
        element = {'tag': tag, 'text': '', **values}
        self.elements.append(element)
        if tag in FORBIDDEN_TAGS or any(name.startswith('on') for name in values):
            self.faults.append(f'<{tag} {attributes}> is forbidden')
        if 'id' in values:
            if values['id'] in self.ids:
                self.faults.append(f'two elements have the id {values["id"]}')
            self.ids.add(values['id'])
        if 'href' in values:
            self.links.append(values['href'])
        if values.get('http-equiv') == 'Content-Security-Policy':
            self.policy = values['content']
        if tag not in VOID and not self.get_starttag_text().endswith('/>'):
            self.open.append(element)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)

    def handle_endtag(self, tag):
        if tag in VOID or not self.open or self.open[-1]['tag'] != tag:
            self.faults.append(f'{self.getpos()}: </{tag}> closes nothing')
            return
        if tag == 'script':
            self.scripts.append(self.open[-1]['text'])
        self.open.pop()

    def handle_data(self, data):
        for element in self.open:
            element['text'] += data

    def find(self, tag, **values):
        return [element for element in self.elements if element['tag'] == tag and
                all(element.get(name) == value for name, value in values.items())]

    def problems(self):
        """Returns the faults, external references, and links without a target."""
        found = list(self.faults)
        found += [f'href {link}' for link in self.links if not link.startswith('#')]
        found += [f'{link} leads nowhere' for link in self.links
                  if '=' not in link and link[1:] not in self.ids]
        for style in self.find('style'):
            found += re.findall(r'url\([^)]*\)|@import[^;]*', style['text'])
        hashes = ["'sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() + "'"
                  for script in self.scripts]
        wanted = f"default-src 'none'; style-src 'unsafe-inline'; script-src {' '.join(hashes)}; "
        if not self.policy.startswith(wanted):
            found.append(f'the policy is {self.policy}')
        return found

    def rows(self):
        """Returns the table of programs: its rows' texts by cell, in order."""
        table, = self.find('table', id='programs')
        return re.findall(r'\S.*', table['text'])
