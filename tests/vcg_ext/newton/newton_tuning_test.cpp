// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/newton_tuning.h"
#include "support/newton_checks.h"

#include <set>

namespace developable::test {
namespace {

TEST(NewtonTuning, NamesEveryConstantOnce) {
	std::size_t bytes = 0;
	std::set<std::string> names;
	for (const TuningConstant& constant : tuningConstants()) {
		bytes += std::holds_alternative<int NewtonTuning::*>(constant.member) ? sizeof(int) : sizeof(double);
		names.insert(constant.name);
		EXPECT_GT(constant.value({}), 0) << constant.name;
	}
	EXPECT_EQ(names.size(), tuningConstants().size());
	EXPECT_LE(bytes, sizeof(NewtonTuning));
	EXPECT_GT(bytes + tuningConstants().size() * sizeof(int), sizeof(NewtonTuning)); // but for padding
}

TEST(NewtonTuning, SetsConstantsByName) {
	for (const TuningConstant& constant : tuningConstants()) {
		NewtonTuning tuning;
		constant.set(tuning, 4 * constant.value(tuning));
		EXPECT_EQ(constant.value(tuning), 4 * constant.value({}));
		int changed = 0;
		for (const TuningConstant& other : tuningConstants())
			changed += other.value(tuning) != other.value({});
		EXPECT_EQ(changed, 1);
	}
}

TEST(NewtonTuning, IsWhatTheMethodGoesBy) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, wave));
	Positions usual = assembly.originalPositions, other = usual;
	ConstrainedNewtonOptions options;
	EXPECT_EQ(constrainedNewton(assembly, usual, options).status, Status::Converged);
	options.tuning.firstEpsilon = 4;
	EXPECT_EQ(constrainedNewton(assembly, other, options).status, Status::Converged);
	EXPECT_NE(usual, other);
	EXPECT_LT((usual - other).cwiseAbs().maxCoeff(), 0.05);
}

} // namespace
} // namespace developable::test
