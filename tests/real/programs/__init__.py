"""The real programs, by name."""

from programs import irrlicht, mplayer, openscad, wildmagic, wine

PROGRAMS = {p.name: p for p in (openscad.PROGRAM, mplayer.PROGRAM, irrlicht.PROGRAM, wine.PROGRAM,
                               wildmagic.PROGRAM)}
