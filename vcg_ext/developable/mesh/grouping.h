// SPDX-License-Identifier: GPL-3.0-or-later
// grouping.h: things sorted into groups by counting: the corners of each vertex, the half edges of each
// start, and the like.
#pragma once

#include <vector>

namespace developable {

/// Group g has members[start[g]] to members[start[g + 1] - 1], in ascending order.
struct Groups {
	std::vector<int> start;   ///< groups + 1
	std::vector<int> members; ///< numbers from 0

	int count() const { return static_cast<int>(start.size()) - 1; }
	int size(int group) const { return start[group + 1] - start[group]; }
	const int* begin(int group) const { return members.data() + start[group]; }
	const int* end(int group) const { return members.data() + start[group + 1]; }
};

/// \param groupOf  of each member, 0 to members - 1, the number of its group, 0 to groups - 1
template <class GroupOf>
Groups grouped(int groups, int members, const GroupOf& groupOf) {
	Groups result;
	result.start.assign(groups + 1, 0);
	for (int member = 0; member < members; ++member)
		++result.start[groupOf(member) + 1];
	for (int group = 0; group < groups; ++group)
		result.start[group + 1] += result.start[group];
	result.members.resize(members);
	std::vector<int> next(result.start.begin(), result.start.end() - 1);
	for (int member = 0; member < members; ++member)
		result.members[next[groupOf(member)]++] = member;
	return result;
}

/// Those of the numbers from 0 to below a count for which a condition holds, ascending.
template <class Condition>
std::vector<int> indicesWhere(int count, const Condition& condition) {
	std::vector<int> found;
	for (int i = 0; i < count; ++i)
		if (condition(i))
			found.push_back(i);
	return found;
}

} // namespace developable
