#!/usr/bin/env python3
"""Generates the layer's entry points from Khronos' gl.xml, entry_points.toml and software.toml.

Its options select the outputs: the host table, its loader, the declarations of the handlers, the exported
entry points with the table of names, the linker's version script and the list of exports.
Only the standard library of Python 3.11 is used. Every row of the TOML must match a command of
gl.xml, and a command takes one action: anything else fails the build.
"""
import argparse

import gl_commands
import host_tables
import software_thunks
import thunks


def export_names(table):
    names = list(table.config.get("exports", {}).get("names", []))
    for name in list(table.action) + software_thunks.leads(table):
        names += table.entry_names(name)
    return sorted(set(names))


def version_script(table):
    body = "".join(f"    {name};\n" for name in export_names(table))
    return f"{{\n  global:\n{body}  local:\n    *;\n}};\n"


WRITERS = {
    "host-header": host_tables.header, "host-source": host_tables.source,
    "null-table": host_tables.null_table, "recording-table": host_tables.recording_table,
    "handlers": thunks.handlers_header, "entry-points": thunks.entry_points_source,
    "software-points": software_thunks.source, "version-script": version_script,
    "export-list": lambda table: "".join(n + "\n" for n in export_names(table)),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gl_xml")
    parser.add_argument("entry_points_toml")
    parser.add_argument("software_toml")
    for option in WRITERS:
        parser.add_argument("--" + option, metavar="FILE")
    arguments = vars(parser.parse_args())
    table = gl_commands.read_table(arguments["gl_xml"], arguments["entry_points_toml"],
                                   arguments["software_toml"])
    for option, writer in WRITERS.items():
        path = arguments[option.replace("-", "_")]
        if path:
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(writer(table))


if __name__ == "__main__":
    main()
