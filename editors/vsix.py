#!/usr/bin/env python3
"""Packs editors/vscode as an extension that Visual Studio Code installs from a file; needs no network.

usage: editors/vsix.py OUTPUT.vsix
       code --install-extension OUTPUT.vsix
"""
import json
import pathlib
import sys
import zipfile
from xml.sax.saxutils import escape, quoteattr

EDITORS = pathlib.Path(__file__).resolve().parent
EXTENSION = EDITORS / 'vscode'
EARLIEST = (1980, 1, 1, 0, 0, 0)  # what a ZIP archive can say: two packings are the same bytes

MANIFEST = '''<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id={id} Version={version} Publisher={publisher} />
    <DisplayName>{title}</DisplayName>
    <Description xml:space="preserve">{description}</Description>
    <Tags>{tags}</Tags>
    <Categories>{categories}</Categories>
    <License>extension/LICENSE.txt</License>
    <Properties>
      <Property Id="Microsoft.VisualStudio.Code.Engine" Value={engine} />
    </Properties>
  </Metadata>
  <Installation>
    <InstallationTarget Id="Microsoft.VisualStudio.Code" />
  </Installation>
  <Dependencies />
  <Assets>
    <Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Content.License" Path="extension/LICENSE.txt" Addressable="true" />
  </Assets>
</PackageManifest>
'''
MEDIA = {'.json': 'application/json', '.js': 'application/javascript', '.txt': 'text/plain',
         '.vsixmanifest': 'text/xml'}


def manifest():
    package = json.loads((EXTENSION / 'package.json').read_text())
    languages = [language['id'] for language in package['contributes']['languages']]
    return MANIFEST.format(
        id=quoteattr(package['name']), version=quoteattr(package['version']),
        publisher=quoteattr(package['publisher']), engine=quoteattr(package['engines']['vscode']),
        title=escape(package['displayName']), description=escape(package['description']),
        tags=escape(','.join(languages)), categories=escape(','.join(package['categories'])))


def content_types():
    rows = ''.join(f'<Default Extension="{ending}" ContentType="{kind}"/>' for ending, kind in MEDIA.items())
    return ('<?xml version="1.0" encoding="utf-8"?>\n<Types xmlns='
            f'"http://schemas.openxmlformats.org/package/2006/content-types">{rows}</Types>\n')


def pack(output):
    files = {'[Content_Types].xml': content_types().encode(), 'extension.vsixmanifest': manifest().encode(),
             'extension/LICENSE.txt': (EDITORS.parent / 'LICENSE').read_bytes()}
    for path in sorted(EXTENSION.rglob('*')):
        if path.is_file():
            files['extension/' + path.relative_to(EXTENSION).as_posix()] = path.read_bytes()
    with zipfile.ZipFile(output, 'w', zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, EARLIEST)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)


if __name__ == '__main__':
    if len(sys.argv) != 2 or sys.argv[1].startswith('-'):
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    pack(sys.argv[1])
