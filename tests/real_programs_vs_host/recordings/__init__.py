"""Replays recordings of programs on the bare host and with the layer, and compares every frame."""
