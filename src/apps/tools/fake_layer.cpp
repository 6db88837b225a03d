// An empty library to preload: the tests of `arbiter run` examine only the environment.
extern "C" int arbiterFakeLayer() { return 0; }
