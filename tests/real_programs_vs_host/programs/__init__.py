"""The real programs, by name. The first four are the acceptance test; the others are more evidence."""

from programs import (clutter, coin, games, gem, hacks, irrlicht, mplayer, openscad, osgfx, pyopengl, qtvideo,
                      qutemol, savers, wildmagic, wine, xine)

_ALL = (openscad, mplayer, irrlicht, wine, wildmagic, savers, xine, qutemol, pyopengl, osgfx, coin,
        gem, clutter, qtvideo, hacks, games)
PROGRAMS = {module.PROGRAM.name: module.PROGRAM for module in _ALL}
