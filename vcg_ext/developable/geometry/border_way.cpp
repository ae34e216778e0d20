// SPDX-License-Identifier: GPL-3.0-or-later
// border_way.cpp: one way round or the other.
#include "border_way.h"

namespace developable::detail {

namespace {

BorderWay wayFrom(const std::vector<double>& begins, int from, int to) {
	const int edges = static_cast<int>(begins.size()) - 1;
	const double between = begins[to + 1] - begins[from];
	return from <= to ? BorderWay{from, to - from + 1, between}
					  : BorderWay{from, to - from + 1 + edges, between + begins.back()};
}

} // namespace

BorderWay shorterWay(const std::vector<double>& begins, int a, int b) {
	const BorderWay one = wayFrom(begins, a, b), other = wayFrom(begins, b, a);
	return one.length <= other.length ? one : other;
}

} // namespace developable::detail
