// SPDX-License-Identifier: GPL-3.0-or-later
// global_developability.cpp: the filter Global Developability (Section 4).
#include "../layer.h"
#include "../material_verdict.h"
#include "../materials.h"
#include "../optimize_layer.h"
#include "../shared_parameters.h"
#include "filters.h"

#include "developable/bounded_strain/bounded_strain.h"
#include "developable/geometry/geometry.h"
#include "developable/newton/constrained_newton.h"
#include "developable/penalty/penalty_method.h"

#include <algorithm>

namespace developable::plugin {

namespace {

/// In the order of the `solver` enumeration.
enum class Solver { ConstrainedNewton, ConjugateGradient };

/// In the same order.
std::vector<std::string> solverNames() {
	return {"Constrained Newton", "Conjugate gradient"};
}

std::string nameOf(Solver solver) {
	return solverNames()[std::size_t(solver)];
}

/// Hosts may have rounded to float what the user typed: stay below that.
double largestDisplacement(const ParameterValues& values, int lengthExponent) {
	return inWorkingUnits(lengthExponent, values.number("max_displacement")) * (1 - 1.2e-7);
}

OptimizationReport runConjugateGradient(const ParameterValues& values, const PatchAssembly& assembly,
										Positions& positions, const Progress& progress) {
	PenaltyMethodOptions options;
	options.angleTolerance = values.number("angle_tolerance");
	options.relativeChange = values.number("relative_change");
	options.maxIterations = values.integer("max_iterations");
	return penaltyMethod(assembly, positions, options, progress);
}

OptimizationReport runConstrainedNewton(const ParameterValues& values, const PatchAssembly& assembly,
										Positions& positions, const Progress& progress) {
	ConstrainedNewtonOptions options;
	options.angleTolerance = values.number("angle_tolerance");
	options.curvatureTolerance = values.number("curvature_tolerance");
	options.maxIterations = values.integer("max_iterations");
	options.smoothness = chosenSmoothness(values);
	options.fairness = values.number("fairness");
	options.maxDisplacement = largestDisplacement(values, assembly.lengthExponent);
	return constrainedNewton(assembly, positions, options, progress);
}

/// As near as the material lets the shape stay.
/// \param known  to be set to the result's patterns where there are some
OptimizationReport runBoundedStrain(const ParameterValues& values, const PatchAssembly& assembly,
									Positions& positions, KnownPatterns& known, const Progress& progress) {
	BoundedStrainOptions options;
	options.bounds = strainBounds(values);
	options.grain = chosenGrain(values);
	options.maxIterations = values.integer("max_iterations");
	options.smoothness = chosenSmoothness(values);
	options.fairness = values.number("fairness");
	options.maxDisplacement = largestDisplacement(values, assembly.lengthExponent);
	options.leastRadius = inWorkingUnits(assembly.lengthExponent, smallestRadius(values));
	BoundedStrainReport report = boundedStrain(assembly, positions, options, progress);
	if (!report.patterns.pieces.empty())
		known = {positions, std::move(report.patterns)};
	return report;
}

Results runGlobal(FilterCall& call) {
	const ParameterValues& values = call.values;
	const bool newton = values.choice<Solver>("solver") == Solver::ConstrainedNewton;
	const bool strained = newton && strainBounds(values).any();
	KnownPatterns known;
	const Method method = [&](const PatchAssembly& assembly, Positions& positions, const Progress& progress) {
		if (strained)
			return runBoundedStrain(values, assembly, positions, known, progress);
		return newton ? runConstrainedNewton(values, assembly, positions, progress)
					  : runConjugateGradient(values, assembly, positions, progress);
	};
	Optimized optimized = optimizeLayer(call, method);
	optimized.results.push_back(
		{"max_border_angle", borderAngles(optimized.assembly, optimized.positions).maxCoeff(), ""});
	const std::vector<PanelStrain> strains =
		judgeMaterial(call, optimized.assembly, optimized.positions, known, optimized.results);
	if (!optimized.stopped && !strains.empty())
		writeStrains(call.layer.mesh(), optimized.assembly, strains);
	judgeBending(call, optimized.assembly, optimized.positions);
	return optimized.results;
}

/// A parameter that only one solver looks at.
Parameter onlyFor(Solver solver, Parameter parameter) {
	parameter.onlyForSolver = nameOf(solver);
	parameter.tooltip = parameter.onlyForSolver + " only: " + parameter.tooltip;
	return parameter;
}

/// As in other filters, but one solver does not take 0.
Parameter positiveAngleTolerance() {
	Parameter parameter = angleToleranceParameter();
	parameter.positiveForSolver = nameOf(Solver::ConstrainedNewton);
	return parameter;
}

std::vector<Parameter> globalParameters() {
	std::vector<Parameter> all = {
		enumeration(
			"solver", solverNames(), 0, "Method",
			"How the shape is found: by Newton steps all the way to developable, or as in the paper. The steps "
			"bring all angle defects to zero at the least deformation; the paper's conjugate gradients with a "
			"penalty (Section 4.1) stop short of that."),
		patchesParameter(),
		weldDistanceParameter(),
		onlySelectedParameter(),
		fixBoundaryParameter(),
		fixSelectedParameter(),
		positiveAngleTolerance(),
		onlyFor(Solver::ConstrainedNewton,
				floatParameter(
					"curvature_tolerance", 1e-4, {0, true}, "rad", "Angles left in a panel",
					"a patch is developable when its absolute angle defects add up to no more than this.")),
		intParameter(
			"max_iterations", 200, 0, "Steps at most",
			"The run ends after so many steps at the latest. It is the paper's N_max (Section 4.1)."),
		onlyFor(
			Solver::ConjugateGradient,
			floatParameter("relative_change", 1e-4, {0}, "", "Least progress of a step",
						   "the run ends when a step changes G by less than this share of its first value. G "
						   "is the detect function, and this the paper's eta of 0.01 % (Section 4.1).")),
		onlyFor(Solver::ConstrainedNewton,
				floatParameter(
					"smoothness", ConstrainedNewtonOptions().smoothness, {0, true, 1}, "", "Smoothness",
					"how much weight bending has against distance; larger values give fewer wrinkles. "
					"They also move the surface more. At the default it is what suits the material.")),
		onlyFor(Solver::ConstrainedNewton,
				floatParameter("fairness", ConstrainedNewtonOptions().fairness, {0, false, 1}, "",
							   "Detail smoothed away",
							   "how much detail is smoothed away: bumps shorter than this share of "
							   "the size of their part. At 0 the surface keeps its detail.")),
		onlyFor(
			Solver::ConstrainedNewton,
			automaticLength(
				"max_displacement", "Move no farther than",
				"no vertex ends farther than this from where it was; -1 means 15 % of its part's diagonal. "
				"A part is what shares vertices or is sewn together; any negative number means that.")),
	};
	for (const Parameter& parameter : materialParameters())
		all.push_back(onlyFor(Solver::ConstrainedNewton, parameter));
	all.push_back(onlyFor(Solver::ConstrainedNewton, thicknessParameter()));
	all.push_back(mapParameter(Map::Displacement));
	all.push_back(colorizeParameter());
	return all;
}

} // namespace

FilterDescription globalDevelopability() {
	FilterDescription filter;
	filter.name = "Global Developability";
	filter.pythonName = "apply_coord_global_developability";
	filter.shortName = "global";
	filter.filterClass = FilterClass::Smoothing;
	filter.change = Change::Positions;
	// Short: the dialog has to fit on a small screen with all its parameters.
	filter.help =
		"Makes each panel of the layer <b>developable</b>, so that it can be cut from a flat sheet, while the "
		"surface moves as little as possible and seams stay closed. The log begins with what came of it and says "
		"where a cut is needed, as on closed surfaces. There is no undo: <b>Restore Original Shape</b> takes it "
		"back.<br>"
		"See: <i>C. C. L. Wang, K. Tang</i>, The Visual Computer 20, 2004.";
	filter.parameters = globalParameters();
	filter.run = runGlobal;
	return filter;
}

} // namespace developable::plugin
