// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/report.h"

#include <gtest/gtest.h>

#include <set>

namespace developable::test {
namespace {

TEST(Report, PropertiesAreInTheOrderOfTheNumbers) {
	std::set<std::string> names;
	int number = 0;
	for (const StatusProperties& properties : statusProperties) {
		EXPECT_EQ(static_cast<int>(properties.status), number++);
		EXPECT_EQ(describe(properties.status), properties.text);
		names.insert(properties.name);
	}
	EXPECT_EQ(static_cast<int>(names.size()), number);
	number = 0;
	for (const ReasonProperties& properties : reasonProperties)
		EXPECT_EQ(static_cast<int>(properties.reason), number++);
}

TEST(Report, OnlyDevelopableShapesAreConverged) {
	for (const StatusProperties& properties : statusProperties)
		EXPECT_EQ(converged(properties.status),
				  properties.status == Status::Converged || properties.status == Status::NothingToDo);
}

} // namespace
} // namespace developable::test
