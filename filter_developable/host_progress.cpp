// SPDX-License-Identifier: GPL-3.0-or-later
// host_progress.cpp: the pace at which hosts hear of progress.
#include "host_progress.h"

#include <algorithm>
#include <chrono>

namespace developable::plugin {

Progress hostProgress(vcg::CallBackPos* callback) {
	if (callback == nullptr)
		return {};
	using Clock = std::chrono::steady_clock;
	constexpr std::chrono::milliseconds pause(50);
	return [callback, pause, next = Clock::time_point(), mayGoOn = true](double fractionDone,
																		 const std::string& message) mutable {
		const Clock::time_point now = Clock::now();
		if (!mayGoOn || now < next)
			return mayGoOn;
		next = now + pause;
		mayGoOn = callback(static_cast<int>(100 * std::clamp(fractionDone, 0.0, 1.0)), message.c_str());
		return mayGoOn;
	};
}

} // namespace developable::plugin
