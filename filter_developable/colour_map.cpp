// SPDX-License-Identifier: GPL-3.0-or-later
// colour_map.cpp: values to colours, by ramps in OKLab.
#include "colour_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace developable::plugin {

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

/// A colour of OKLab: lightness and two opponent axes, green to red and blue to yellow.
using OkLab = Eigen::Vector3d;

OkLab pointOnCircle(double lightness, const Eigen::Vector2d& centre, double radius, double angle) {
	return {lightness, centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
}

/// \param share  0 to 1
OkLab oneSidedColour(double share) {
	const double lightness = 0.9 - 0.54 * share, angle = (120 - 200 * share) * degree;
	return pointOnCircle(lightness, {0.05, -0.04}, 0.13, angle);
}

/// \param share  -1 to 1
OkLab signedColour(double share) {
	const OkLab middle(0.87, 0, 0);
	const OkLab end = pointOnCircle(0.5, {0, 0}, 0.19, (share < 0 ? 262 : 30) * degree);
	return middle + std::abs(share) * (end - middle);
}

/// From linear light to the stored byte (IEC 61966-2-1).
unsigned char encoded(double light) {
	const double bounded = std::clamp(light, 0.0, 1.0);
	const double value = bounded <= 0.0031308 ? 12.92 * bounded : 1.055 * std::pow(bounded, 1 / 2.4) - 0.055;
	return static_cast<unsigned char>(std::lround(255 * value));
}

/// Ottosson's two matrices with the cube between them.
vcg::Color4b toSrgb(const OkLab& colour) {
	Eigen::Matrix3d toCones, toLight;
	toCones << 1, 0.3963377774, 0.2158037573, //
		1, -0.1055613458, -0.0638541728,      //
		1, -0.0894841775, -1.2914855480;
	toLight << 4.0767416621, -3.3077115913, 0.2309699292, //
		-1.2684380046, 2.6097574011, -0.3413193965,       //
		-0.0041960863, -0.7034186147, 1.7076147010;
	const Eigen::Vector3d light = toLight * (toCones * colour).array().cube().matrix();
	return {encoded(light[0]), encoded(light[1]), encoded(light[2]), 255};
}

} // namespace

ColourRange colourRange(const Eigen::VectorXd& values, bool isSigned, double noise) {
	std::vector<double> sizes;
	for (const double value : values)
		if (std::abs(value) > noise)
			sizes.push_back(std::abs(value));
	double high = noise;
	if (!sizes.empty()) {
		const auto shown = static_cast<std::ptrdiff_t>(std::ceil(shownShare * double(sizes.size())));
		std::nth_element(sizes.begin(), sizes.begin() + shown - 1, sizes.end());
		high = sizes[std::size_t(shown - 1)];
	}
	return {isSigned ? -high : 0, high};
}

std::vector<vcg::Color4b> mapColours(const Eigen::VectorXd& values, const ColourRange& range) {
	std::vector<vcg::Color4b> colours;
	colours.reserve(std::size_t(values.size()));
	for (const double value : values) {
		const double share = std::clamp(value, range.low, range.high) / range.high;
		colours.push_back(toSrgb(range.isSigned() ? signedColour(share) : oneSidedColour(share)));
	}
	return colours;
}

std::string describe(const ColourRange& range, const std::string& high, const Eigen::VectorXd& values) {
	const auto beyond = (values.array() < range.low || values.array() > range.high).count();
	return (range.isSigned() ? "blue at -" + high + ", light grey at 0, red at " + high
							 : "light yellow at 0, red in the middle, dark violet at " + high) +
		   "; " + std::to_string(beyond) + " of " + std::to_string(values.size()) + " places lie beyond";
}

} // namespace developable::plugin
