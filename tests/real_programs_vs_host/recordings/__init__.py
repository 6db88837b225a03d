"""Recordings of programs, replayed on the bare host and with the layer, every frame compared."""
