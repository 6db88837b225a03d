extern "C" int earlyWasRight();

int main() { return earlyWasRight() ? 0 : 1; }
