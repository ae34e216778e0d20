// SPDX-License-Identifier: GPL-3.0-or-later
// replay.cpp: runs the fuzz target on files, where there is no libFuzzer to do so.
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

int main(int argc, char** argv) {
	if (argc < 2) {
		std::cerr << "usage: fuzz_target FILE...\n";
		return 2;
	}
	for (int i = 1; i < argc; ++i) {
		std::ifstream file(argv[i], std::ios::binary);
		const std::vector<char> content{std::istreambuf_iterator<char>(file), {}};
		if (!file) {
			std::cerr << argv[i] << " can't be read\n";
			return 2;
		}
		std::cout << argv[i] << std::endl;
		LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
	}
	return 0;
}
