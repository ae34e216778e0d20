// SPDX-License-Identifier: GPL-3.0-or-later
// parameter_values.h: what the user chose for a filter's parameters, whichever host it came from.
#pragma once

#include <map>
#include <string>
#include <variant>

class CMeshO;

namespace developable::plugin {

/// Values by parameter name. Enumerations are their index, lengths are absolute, meshes are never null.
class ParameterValues {
public:
	using Value = std::variant<bool, int, double, const CMeshO*>;

	void set(const std::string& name, Value value) { values_[name] = value; }

	bool has(const std::string& name) const { return values_.count(name) > 0; }
	bool boolean(const std::string& name) const { return std::get<bool>(values_.at(name)); }
	int integer(const std::string& name) const { return std::get<int>(values_.at(name)); }
	double number(const std::string& name) const { return std::get<double>(values_.at(name)); }
	const CMeshO& mesh(const std::string& name) const { return *std::get<const CMeshO*>(values_.at(name)); }

	/// An enumeration's value; its order here must be that of the enumeration.
	template <class Enum>
	Enum choice(const std::string& name) const {
		return static_cast<Enum>(integer(name));
	}

private:
	std::map<std::string, Value> values_;
};

} // namespace developable::plugin
