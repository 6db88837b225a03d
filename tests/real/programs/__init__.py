"""The real programs, by name. The first four are the acceptance; the others are more evidence."""

from programs import (irrlicht, mplayer, openscad, pyopengl, qutemol, savers, wildmagic, wine,
                      xine)

_ALL = (openscad, mplayer, irrlicht, wine, wildmagic, savers, xine, qutemol, pyopengl)
PROGRAMS = {module.PROGRAM.name: module.PROGRAM for module in _ALL}
