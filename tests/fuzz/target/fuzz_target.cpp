// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_target.cpp: one mesh and one method on it, all chosen by bytes. What oracles.h finds wrong ends the
// process.
#include "hostile_mesh.h"
#include "runs.h"

#include <cstdlib>
#include <iostream>

namespace developable::fuzz {

namespace {

void endAt(const char* method, const Findings& findings) {
	for (const std::string& text : findings.texts())
		std::cerr << method << ": " << text << std::endl;
	if (!findings.texts().empty())
		std::abort();
}

} // namespace

} // namespace developable::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
	using namespace developable;
	using namespace developable::fuzz;
	Random random(bytes, count);
	const Method& method = methods[std::size_t(random.below(int(methods.size())))];
	const TriangleMesh mesh = hostileMesh(random);
	const PatchOptions options = hostilePatchOptions(random, mesh);
	PatchAssembly assembly;
	Findings ofAssembly, ofMethod;
	const bool assembled = assembleAndCheck(mesh, options, assembly, ofAssembly);
	endAt("assemblePatches", ofAssembly);
	if (assembled)
		attempt([&] { method.run(random, assembly, ofMethod); }, ofMethod);
	endAt(method.name, ofMethod);
	return 0;
}
