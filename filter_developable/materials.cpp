// SPDX-License-Identifier: GPL-3.0-or-later
// materials.cpp: the table from its text, and bounds from parameters.
#include "materials.h"

#include "shared_parameters.h"

#include "developable/newton/constrained_newton.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <cstdlib>

namespace developable::plugin {

namespace {

constexpr double onePerCent = 0.01;
constexpr double ofMaterial = -1; ///< a bound that the material decides

double number(const QJsonObject& object, const QString& key) {
	const QJsonValue value = object[key];
	if (!value.isDouble())
		throw InvalidParameter("The material of your own has no number for '" + key.toStdString() +
							   "': see docs/materials.md for the form of an entry.");
	return value.toDouble();
}

double numberOrNothing(const QJsonObject& object, const QString& key) {
	return object.contains(key) ? number(object, key) : 0;
}

/// A number for all directions, or one for each.
/// \param bound  DirectionBounds::stretch or DirectionBounds::compression
void readBounds(const QJsonObject& entry, const QString& key, double DirectionBounds::*bound,
				StrainBounds& bounds) {
	if (!entry[key].isObject()) {
		for (DirectionBounds* direction : {&bounds.warp, &bounds.weft, &bounds.bias})
			direction->*bound = onePerCent * number(entry, key);
		return;
	}
	const QJsonObject directions = entry[key].toObject();
	bounds.directed = true;
	bounds.warp.*bound = onePerCent * number(directions, "warp");
	bounds.weft.*bound = onePerCent * number(directions, "weft");
	bounds.bias.*bound = onePerCent * number(directions, "bias");
}

Material readMaterial(const QJsonObject& entry) {
	Material material;
	material.name = entry["name"].toString().toStdString();
	readBounds(entry, "stretch", &DirectionBounds::stretch, material.bounds);
	readBounds(entry, "compression", &DirectionBounds::compression, material.bounds);
	material.elasticStrain = onePerCent * numberOrNothing(entry, "elastic_strain");
	material.thickness = numberOrNothing(entry, "thickness");
	material.smoothness = numberOrNothing(entry, "smoothness");
	material.source = entry["source"].toString().toStdString();
	return material;
}

std::vector<Material> readMaterials() {
	std::vector<Material> result;
	const QJsonDocument document = QJsonDocument::fromJson(materialsText());
	const QJsonArray entries = document.object()["materials"].toArray();
	for (const QJsonValue& value : entries)
		result.push_back(readMaterial(value.toObject()));
	return result;
}

/// A bound that is asked for holds in every direction.
void setBound(const ParameterValues& values, const char* name, double DirectionBounds::*bound,
			  StrainBounds& bounds) {
	const double value = values.number(name);
	if (value == ofMaterial)
		return;
	requireOption(value >= 0, std::string("The parameter '") + name +
								  "' is negative: choose 0 or more, or -1 for what the material bears.");
	for (DirectionBounds* direction : {&bounds.warp, &bounds.weft, &bounds.bias})
		direction->*bound = onePerCent * value;
}

} // namespace

const std::vector<Material>& materials() {
	static const std::vector<Material> all = readMaterials();
	return all;
}

std::vector<Parameter> materialParameters() {
	std::vector<std::string> names;
	for (const Material& material : materials())
		names.push_back(material.name);
	return {
		enumeration("material", names, 0, "Material",
					"What the panels are made of, which says how far they may be stretched and compressed. "
					"docs/materials.md says where the numbers come from."),
		floatParameter(
			"allowed_stretch", ofMaterial, {ofMaterial, false, 1000}, "%", "Allowed stretch",
			"How much longer the material may be on the shape than in the pattern; -1 is what it bears. "
			"That is 0 for Custom, the method of zero strain."),
		floatParameter(
			"allowed_compression", ofMaterial, {ofMaterial, false, 100}, "%", "Allowed compression",
			"How much shorter the material may be on the shape than in the pattern; -1 is what it bears. "
			"That is 0 for Custom, the method of zero strain."),
		enumeration("grain", {"Longest seam", "X axis", "Y axis", "Z axis"}, 0, "Grain",
					"Which way the grain, the warp of a cloth, runs in every panel. It matters for materials "
					"that bear more in one direction than in another."),
	};
}

Parameter thicknessParameter() {
	return lengthParameter(
		"thickness", 0, "Thickness",
		"How thick the material is, in the mesh's unit; 0 means that bending is not judged. Else the surface "
		"stays above the radius that such a sheet bears, where its strain lets it, and the log says how much of "
		"the area is bent more tightly.");
}

Material chosenMaterial(const ParameterValues& values) {
	const auto index = static_cast<std::size_t>(values.integer("material"));
	const char* own = std::getenv(ownMaterialVariable);
	return index == 0 && own != nullptr ? readMaterial(QJsonDocument::fromJson(own).object())
										: materials()[index];
}

Grain chosenGrain(const ParameterValues& values) {
	const auto choice = values.choice<Grain::Choice>("grain");
	const char* own = std::getenv(ownGrainVariable);
	if (choice != Grain::LongestSeam || own == nullptr)
		return choice;
	const QJsonArray numbers = QJsonDocument::fromJson(own).array();
	Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // which is none
	for (int i = 0; i < 3 && numbers.size() == 3; ++i)
		direction[i] = numbers[i].toDouble();
	return Grain(direction);
}

double smallestRadius(const ParameterValues& values) {
	const double elasticStrain = chosenMaterial(values).elasticStrain;
	return elasticStrain > 0 ? leastBendingRadius(values.number("thickness"), elasticStrain) : 0;
}

double chosenSmoothness(const ParameterValues& values) {
	const double ofFilter = ConstrainedNewtonOptions().smoothness,
				 suiting = chosenMaterial(values).smoothness;
	const double asked = values.has("smoothness") ? values.number("smoothness") : ofFilter;
	// Hosts may have rounded the default to float.
	return suiting > 0 && std::abs(asked - ofFilter) < 1e-6 * ofFilter ? suiting : asked;
}

StrainBounds strainBounds(const ParameterValues& values) {
	StrainBounds bounds = chosenMaterial(values).bounds;
	setBound(values, "allowed_stretch", &DirectionBounds::stretch, bounds);
	setBound(values, "allowed_compression", &DirectionBounds::compression, bounds);
	bounds.directed = bounds.directed &&
					  !(values.number("allowed_stretch") >= 0 && values.number("allowed_compression") >= 0);
	requireValid(bounds);
	return bounds;
}

} // namespace developable::plugin
