// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz.cpp: every method on hostile meshes, one a seed.
//
//   fuzz SEED COUNT [SECONDS]
//
// runs the seeds from SEED on, COUNT of them or as many as fit into SECONDS. Each either has to throw one of
// the library's own exceptions or to give a result that stands up to oracles.h. Says what does not, with its
// seed, how many calls there were and how often each method came to a result. Exit code 1 when anything was
// found.
//
// A child process does the work, so that a failed assertion or a sanitizer's verdict costs one seed only.
#include "hostile_mesh.h"
#include "runs.h"

#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <set>

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace developable::fuzz {

namespace {

constexpr long secondsPerSeed = 60;

/// What parent and child both know.
struct Record {
	long seed = 0;           ///< the one being run
	const char* method = ""; ///< alike; parent and child have their texts in the same place
	long end = 0;
	long withFindings = 0;
	long calls = 0; ///< of a reader or a method on one input
	long assembled = 0, refusedMeshes = 0;
	std::array<long, methods.size()> completed = {}, refused = {};
};

void say(long seed, const char* method, const std::string& what) {
	std::cout << "seed " << seed << ": " << method << ": " << what << std::endl;
}

/// Each message once.
bool reportFindings(long seed, const char* method, const Findings& findings) {
	for (const std::string& text : std::set<std::string>(findings.texts().begin(), findings.texts().end()))
		say(seed, method, text);
	return !findings.texts().empty();
}

void runSeed(Record& record) {
	Random random(record.seed);
	record.method = "assemblePatches";
	const TriangleMesh mesh = hostileMesh(random);
	const PatchOptions options = hostilePatchOptions(random, mesh);
	PatchAssembly assembly;
	Findings ofAssembly;
	++record.calls;
	const bool assembled = assembleAndCheck(mesh, options, assembly, ofAssembly);
	++(assembled ? record.assembled : record.refusedMeshes);
	bool found = reportFindings(record.seed, "assemblePatches", ofAssembly);
	for (std::size_t m = 0; assembled && m < methods.size(); ++m) {
		if (!random.chance(methods[m].share))
			continue;
		record.method = methods[m].name;
		Findings findings;
		++record.calls;
		const bool done = attempt([&] { methods[m].run(random, assembly, findings); }, findings);
		++(done ? record.completed : record.refused)[m];
		found |= reportFindings(record.seed, methods[m].name, findings);
	}
	record.withFindings += found;
}

/// Processor time, whatever else the machine does; then SIGPROF ends the process.
void limitTime() {
	itimerval limit = {};
	limit.it_value.tv_sec = secondsPerSeed;
	setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Runs seeds in a child until it ends.
void runInChild(Record& record, std::chrono::steady_clock::time_point deadline) {
	const pid_t child = fork();
	if (child == 0) {
		for (; record.seed < record.end && std::chrono::steady_clock::now() < deadline; ++record.seed) {
			limitTime();
			runSeed(record);
		}
		record.end = record.seed;
		std::exit(0);
	}
	int ending = 0;
	if (child < 0 || waitpid(child, &ending, 0) != child)
		throw std::runtime_error("no process to run in");
	if (WIFEXITED(ending) && WEXITSTATUS(ending) == 0)
		return;
	say(record.seed, record.method,
		WIFSIGNALED(ending) ? "ended by signal " + std::to_string(WTERMSIG(ending))
							: "ended with exit code " + std::to_string(WEXITSTATUS(ending)));
	++record.withFindings;
	++record.seed;
}

int fuzz(long seed, long count, long seconds) {
	void* shared = mmap(nullptr, sizeof(Record), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	if (shared == MAP_FAILED)
		throw std::bad_alloc();
	Record& record = *new (shared) Record;
	record.seed = seed;
	record.end = seed + count;
	const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
	while (record.seed < record.end)
		runInChild(record, deadline);

	std::cout << record.seed - seed << " seeds, " << record.calls << " calls, " << record.withFindings
			  << " seeds with findings\n"
			  << "assemblePatches: " << record.assembled << " results, " << record.refusedMeshes
			  << " refusals\n";
	bool idle = record.assembled == 0;
	for (std::size_t m = 0; m < methods.size(); ++m) {
		std::cout << methods[m].name << ": " << record.completed[m] << " results, " << record.refused[m]
				  << " refusals\n";
		idle |= record.completed[m] == 0;
	}
	// Of some hundred seeds some are work for every method, or the meshes test nothing.
	return record.withFindings > 0 || (idle && count >= 500) ? 1 : 0;
}

} // namespace

} // namespace developable::fuzz

int main(int argc, char** argv) {
	if (argc != 3 && argc != 4) {
		std::cerr << "usage: fuzz SEED COUNT [SECONDS]\n";
		return 2;
	}
	constexpr long anHour = 3600;
	try {
		return developable::fuzz::fuzz(std::atol(argv[1]), std::atol(argv[2]),
									   argc == 4 ? std::atol(argv[3]) : 24 * anHour);
	} catch (const std::exception& error) {
		std::cerr << error.what() << '\n';
		return 1;
	}
}
