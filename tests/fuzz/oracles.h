// SPDX-License-Identifier: GPL-3.0-or-later
// oracles.h: what every result has to be, worked out anew without the library's own functions.
#pragma once

#include "developable/mesh/mesh.h"

#include <exception>
#include <string>
#include <vector>

namespace developable::fuzz {

/// Notes what is wrong, in words.
class Findings {
public:
	void expect(bool holds, const std::string& otherwise) {
		if (!holds)
			texts_.push_back(otherwise);
	}
	const std::vector<std::string>& texts() const { return texts_; }

private:
	std::vector<std::string> texts_;
};

/// Runs something; an exception of the library's own is an answer too.
/// \return whether it came to a result
template <class Run>
bool attempt(const Run& run, Findings& findings) {
	try {
		run();
		return true;
	} catch (const Error& error) {
		findings.expect(std::string(error.what()).size() > 20, "an exception without a sentence");
	} catch (const std::exception& exception) {
		findings.expect(false, std::string("an exception that is not our own: ") + exception.what());
	}
	return false;
}

/// Angle defects, and how far rounding may lead another way of computing them astray.
struct OwnDefects {
	Eigen::VectorXd values; ///< per copy, rad
	Eigen::VectorXd errors; ///< per copy, rad

	double detectFunction() const { return values.squaredNorm(); }
	/// Of the detect function.
	double detectError() const { return 2 * values.cwiseAbs().dot(errors) + errors.squaredNorm(); }
};

/// What counts at the border of a patch.
enum class AtBorders {
	Nothing,          ///< g is 0 there (Eq. 5)
	AnglesBeyondATurn ///< those of a panel that overlaps itself there when laid flat
};

OwnDefects ownDefects(const PatchAssembly& assembly, const Positions& positions,
					  AtBorders atBorders = AtBorders::Nothing);

/// Of each patch, Σ abs(g), rad.
std::vector<double> ownPatchCurvatures(const PatchAssembly& assembly, const OwnDefects& defects);

/// Numbers in range, neighbours that know each other, copies that are inside where all round them is joined,
/// vertices of equal coordinates in one place, held places held.
void checkAssembly(const TriangleMesh& mesh, const PatchOptions& options, const PatchAssembly& assembly,
				   Findings& findings);

/// Takes a mesh apart and checks what comes of it. A refusal that blames coordinates or thin triangles has to
/// be true of as many as it says and of the one that it names; a mesh that has such is refused.
/// \return whether it came to an assembly
bool assembleAndCheck(const TriangleMesh& mesh, const PatchOptions& options, PatchAssembly& assembly,
					  Findings& findings);

/// What all methods promise: finite coordinates, held places exactly where they were, no more G than before.
void checkResult(const PatchAssembly& assembly, const Positions& before, const Positions& after,
				 Findings& findings, AtBorders atBorders = AtBorders::Nothing);

/// That no triangle has flipped against a neighbour, and none has become a sliver.
void checkTrianglesInOrder(const PatchAssembly& assembly, const Positions& after, Findings& findings);

} // namespace developable::fuzz
