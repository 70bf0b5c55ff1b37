#include <cstdio>

unsigned answer();

int main() { std::printf("%u\n", answer()); }
