// SPDX-License-Identifier: GPL-3.0-or-later
// host_progress.cpp: the pace at which hosts hear of progress, and how long the rest will take.
#include "host_progress.h"

#include "results.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace developable::plugin {

namespace {

using Clock = std::chrono::steady_clock;

/// How long the rest takes at the pace so far; nothing while there is no pace to speak of.
std::string estimateInWords(double secondsSoFar, double fractionDone) {
	if (secondsSoFar < 1 || !(fractionDone > 0))
		return "";
	const double left = secondsSoFar * (1 - fractionDone) / fractionDone;
	if (left < 1)
		return "; less than a second left at this pace";
	const auto about = [](double number, const char* unit) {
		return "; about " + std::to_string(std::lround(number)) + " " + unit + " left at this pace";
	};
	if (left < 90)
		return about(left, "seconds");
	if (left < 5400)
		return about(left / 60, "minutes");
	return left < 1e6 ? about(left / 3600, "hours") : "; many days left at this pace";
}

} // namespace

Progress hostProgress(vcg::CallBackPos* callback) {
	if (callback == nullptr)
		return {};
	constexpr std::chrono::milliseconds pause(50);
	return [callback, pause, start = Clock::now(), next = Clock::time_point(),
			mayGoOn = true](double fractionDone, const std::string& message) mutable {
		const Clock::time_point now = Clock::now();
		if (!mayGoOn || now < next)
			return mayGoOn;
		next = now + pause;
		const double done = std::clamp(fractionDone, 0.0, 1.0);
		const std::chrono::duration<double> elapsed = now - start;
		const std::string words = message + estimateInWords(elapsed.count(), done);
		mayGoOn = callback(static_cast<int>(100 * done), words.c_str());
		return mayGoOn;
	};
}

} // namespace developable::plugin
