// SPDX-License-Identifier: GPL-3.0-or-later
// exceptions.h: what is thrown when input cannot be worked on. The mesh is untouched whenever one is thrown.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace developable {

/// Base of everything that this library throws. The message names the problem, how many elements have it and
/// what to do about it, in a sentence that can be shown to the user as it is.
class Error : public std::runtime_error {
public:
	using std::runtime_error::runtime_error;
};

/// The mesh has no faces, or none that was asked for.
class EmptyMesh : public Error {
public:
	using Error::Error;
};

/// A coordinate is infinite or not a number.
class InvalidCoordinate : public Error {
public:
	using Error::Error;
};

/// A triangle has no area, or would have none once its vertices are linked.
class DegenerateTriangle : public Error {
public:
	using Error::Error;
};

/// A patch has no boundary, so it cannot be laid flat (Gauss and Bonnet).
class ClosedPatch : public Error {
public:
	using Error::Error;
};

/// A patch has one side only (a Möbius strip), where a method needs two.
class NonOrientablePatch : public Error {
public:
	using Error::Error;
};

/// A patch has a handle, where a method needs a disk with or without holes.
class PatchWithHandles : public Error {
public:
	using Error::Error;
};

/// The vertices that are held still leave nothing that could be moved.
class NothingFree : public Error {
public:
	using Error::Error;
};

/// An option is out of its range.
class InvalidParameter : public Error {
public:
	using Error::Error;
};

/// The mesh lacks an attribute that was asked for (texture coordinates, face colours, an original position),
/// or its values are no numbers.
class MissingAttribute : public Error {
public:
	using Error::Error;
};

/// \throws InvalidParameter  with that sentence, when an option is out of its range
inline void requireOption(bool valid, const std::string& sentence) {
	if (!valid)
		throw InvalidParameter(sentence);
}

/// "1 triangle has", "3 triangles have": so that messages with numbers read well.
inline std::string counted(std::size_t count, const std::string& singular, const std::string& plural) {
	return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

} // namespace developable
