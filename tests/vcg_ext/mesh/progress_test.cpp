// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/progress.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace developable::test {
namespace {

/// What was said, and a function that says it; the answer is yes until it is told otherwise.
struct Listener {
	std::vector<std::pair<double, std::string>> heard;
	bool answer = true;

	Progress progress() {
		return [this](double fraction, const std::string& message) {
			heard.emplace_back(fraction, message);
			return answer;
		};
	}

	std::vector<double> fractions() const {
		std::vector<double> result;
		for (const auto& [fraction, message] : heard)
			result.push_back(fraction);
		return result;
	}
};

TEST(Progress, PartCountsAsItsShareOfTheWhole) {
	Listener listener;
	const Progress part = partOf(listener.progress(), 0.25, 0.75, "level 2: ");
	for (const double fraction : {0.0, 0.5, 1.0})
		EXPECT_TRUE(part(fraction, "step"));
	EXPECT_EQ(listener.fractions(), (std::vector<double>{0.25, 0.5, 0.75}));
	EXPECT_EQ(listener.heard[0].second, "level 2: step");
}

TEST(Progress, PartOfAPart) {
	Listener listener;
	const Progress inner = partOf(partOf(listener.progress(), 0.5, 1, "outer "), 0, 0.5, "inner ");
	inner(1, "end");
	EXPECT_EQ(listener.heard.back(), (std::pair<double, std::string>(0.75, "outer inner end")));
}

TEST(Progress, NeverBackHoldsWhatWasReached) {
	Listener listener;
	const Progress progress = neverBack(listener.progress());
	const Progress copy = progress; // goes on where the first one is
	progress(0.2, "a");
	progress(0.6, "b");
	copy(0.1, "c");
	copy(0.7, "d");
	progress(0.3, "e");
	EXPECT_EQ(listener.fractions(), (std::vector<double>{0.2, 0.6, 0.6, 0.7, 0.7}));
	EXPECT_EQ(listener.heard[2].second, "c");
	// Another one begins anew.
	neverBack(listener.progress())(0.1, "f");
	EXPECT_EQ(listener.heard.back().first, 0.1);
}

TEST(Progress, StopIsPassedOn) {
	Listener listener;
	const Progress whole = listener.progress();
	for (const Progress& progress : {whole, partOf(whole, 0.5, 1), neverBack(whole)}) {
		listener.answer = true;
		EXPECT_TRUE(mayGoOn(progress, 0.5, ""));
		listener.answer = false;
		EXPECT_FALSE(mayGoOn(progress, 0.5, ""));
	}
	EXPECT_EQ(listener.heard.size(), 6u);
	listener.answer = false;
	const Progress all = neverBack(whole);
	EXPECT_FALSE(all(0.5, ""));
	listener.answer = true;
	EXPECT_FALSE(all(0.6, "")); // other parts of the run have to hear of it, too
	EXPECT_EQ(listener.heard.size(), 7u);
}

TEST(Progress, WithoutAListenerNobodyIsCalledAndTheRunGoesOn) {
	EXPECT_FALSE(partOf({}, 0, 1));
	EXPECT_FALSE(neverBack({}));
	EXPECT_TRUE(mayGoOn({}, 0.5, "step"));
	EXPECT_TRUE(mayGoOn(partOf({}, 0, 0.5, "part "), 0.5, "step"));
}

} // namespace
} // namespace developable::test
