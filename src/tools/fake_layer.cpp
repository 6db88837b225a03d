// Something to preload that does nothing: the tests of `arbiter run` look at the environment only.
extern "C" int arbiterFakeLayer() { return 0; }
