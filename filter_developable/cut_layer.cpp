// SPDX-License-Identifier: GPL-3.0-or-later
// cut_layer.cpp: new vertices and faces with what the old ones had.
#include "cut_layer.h"

#include <vcg/complex/allocate.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace developable::plugin {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

/// All custom attributes of an element copied to another. Their handles are kept in sets, whose order does
/// not matter here.
template <class Attributes>
void copyAttributes(const Attributes& attributes, std::size_t to, std::size_t from) {
	for (const auto& attribute : attributes)
		attribute._handle->CopyValue(to, from, attribute._handle);
}

/// A coordinate with as many digits as those that it is between.
host::Scalar inDigits(host::Scalar coordinate, bool singlePrecision) {
	return singlePrecision ? static_cast<host::Scalar>(narrowed<float>(coordinate)) : coordinate;
}

template <class Number>
Number between(Number a, Number b, double share) {
	return static_cast<Number>((1 - share) * double(a) + share * double(b));
}

/// What of a vertex can be between those of two others.
void setBetween(const Layer& layer, CVertexO& vertex, const CVertexO& a, const CVertexO& b, double share,
				bool singlePrecision) {
	for (int axis = 0; axis < 3; ++axis) {
		vertex.P()[axis] = inDigits(between(a.cP()[axis], b.cP()[axis], share), singlePrecision);
		vertex.N()[axis] = between(a.cN()[axis], b.cN()[axis], share);
	}
	for (int channel = 0; channel < 4; ++channel)
		vertex.C()[channel] = static_cast<unsigned char>(
			std::lround(between(double(a.cC()[channel]), double(b.cC()[channel]), share)));
	vertex.Q() = between(a.cQ(), b.cQ(), share);
	if (!(a.IsS() && b.IsS()))
		vertex.ClearS();
	if (layer.hasVertexTextureCoordinates()) {
		vertex.T().U() = between(a.cT().U(), b.cT().U(), share);
		vertex.T().V() = between(a.cT().V(), b.cT().V(), share);
	}
}

void addVertices(Layer& layer, const CutMesh& cut, bool singlePrecision) {
	CMeshO& mesh = layer.mesh();
	if (cut.added.empty())
		return;
	Allocator::AddVertices(mesh, cut.added.size());
	for (std::size_t i = 0; i < cut.added.size(); ++i) {
		const VertexOrigin& origin = cut.added[i];
		const auto number = std::size_t(cut.verticesBefore) + i, first = std::size_t(origin.first);
		CVertexO& vertex = mesh.vert[number];
		vertex.ImportData(mesh.vert[first]);
		copyAttributes(mesh.vert_attr, number, origin.share > 0.5 ? std::size_t(origin.second) : first);
		if (origin.first != origin.second)
			setBetween(layer, vertex, mesh.vert[first], mesh.vert[std::size_t(origin.second)], origin.share,
					   singlePrecision);
	}
}

/// A face as it was before.
struct FaceBefore {
	std::array<int, 3> vertices;
	std::array<vcg::TexCoord2<float, 1>, 3> texture;
	int flags;
};

/// Where an origin lies in a face, as shares of its corners.
std::array<double, 3> sharesIn(const FaceBefore& face, const VertexOrigin& origin) {
	std::array<double, 3> shares = {0, 0, 0};
	for (std::size_t corner = 0; corner < 3; ++corner) {
		if (face.vertices[corner] == origin.first)
			shares[corner] += 1 - origin.share;
		if (face.vertices[corner] == origin.second)
			shares[corner] += origin.share;
	}
	return shares;
}

class FaceCutter {
public:
	FaceCutter(Layer& layer, const CutMesh& cut)
		: layer_(layer), cut_(cut), facesBefore_(static_cast<int>(layer.mesh().face.size())),
		  faceOfTriangle_(cut.facesAfter(facesBefore_)) {
		CMeshO& mesh = layer.mesh();
		for (CFaceO& face : mesh.face) {
			FaceBefore before{};
			before.flags = face.Flags();
			for (int corner = 0; corner < 3; ++corner) {
				before.vertices[std::size_t(corner)] =
					static_cast<int>(vcg::tri::Index(mesh, face.cV(corner)));
				if (layer.hasTextureCoordinates())
					before.texture[std::size_t(corner)] = face.WT(corner);
			}
			before_.push_back(before);
		}
	}

	void cut() {
		CMeshO& mesh = layer_.mesh();
		const int last = *std::max_element(faceOfTriangle_.begin(), faceOfTriangle_.end());
		if (last >= facesBefore_)
			Allocator::AddFaces(mesh, std::size_t(last + 1 - facesBefore_));
		std::vector<int> parts(std::size_t(facesBefore_), 0);
		for (const int face : cut_.face)
			++parts[std::size_t(face)];
		for (std::size_t t = 0; t < faceOfTriangle_.size(); ++t)
			if (faceOfTriangle_[t] >= facesBefore_) {
				mesh.face[std::size_t(faceOfTriangle_[t])].ImportData(mesh.face[std::size_t(cut_.face[t])]);
				copyAttributes(mesh.face_attr, std::size_t(faceOfTriangle_[t]), std::size_t(cut_.face[t]));
			}
		for (std::size_t t = 0; t < faceOfTriangle_.size(); ++t)
			write(t, parts[std::size_t(cut_.face[t])] > 1);
	}

private:
	void write(std::size_t triangle, bool isPart) {
		CMeshO& mesh = layer_.mesh();
		CFaceO& face = mesh.face[std::size_t(faceOfTriangle_[triangle])];
		const FaceBefore& before = before_[std::size_t(cut_.face[triangle])];
		face.Flags() = before.flags;
		for (int corner = 0; corner < 3; ++corner) {
			const int vertex = cut_.triangles(corner, Eigen::Index(triangle));
			face.V(corner) = &mesh.vert[std::size_t(vertex)];
			if (!isPart)
				continue;
			face.ClearF(corner); // parts are no polygons any more
			if (layer_.hasTextureCoordinates())
				setTexture(face, corner, before, cut_.originOf(vertex));
		}
	}

	static void setTexture(CFaceO& face, int corner, const FaceBefore& before, const VertexOrigin& origin) {
		const std::array<double, 3> shares = sharesIn(before, origin);
		double u = 0, v = 0;
		for (std::size_t i = 0; i < 3; ++i) {
			u += shares[i] * double(before.texture[i].U());
			v += shares[i] * double(before.texture[i].V());
		}
		face.WT(corner).U() = static_cast<float>(u);
		face.WT(corner).V() = static_cast<float>(v);
		face.WT(corner).N() = before.texture[0].N();
	}

	Layer& layer_;
	const CutMesh& cut_;
	const int facesBefore_;
	const std::vector<int> faceOfTriangle_;
	std::vector<FaceBefore> before_;
};

/// Hues that are far apart: each next one is a golden angle on. Neighbours by chance alike take a further
/// one.
vcg::Color4b paint(int number) {
	const double hue = std::fmod(0.13 + 0.618033988749895 * number, 1.0);
	const double value = number % 2 == 0 ? 0.92 : 0.78;
	vcg::Color4b colour;
	colour.SetHSVColor(static_cast<float>(hue), 0.45F, static_cast<float>(value));
	return colour;
}

template <class Value>
auto faceAttribute(CMeshO& mesh, const std::string& name, Value value) {
	Allocator::DeletePerFaceAttribute(mesh, name);
	auto added = Allocator::AddPerFaceAttribute<Value>(mesh, name);
	for (std::size_t face = 0; face < mesh.face.size(); ++face)
		added[face] = value;
	return added;
}

} // namespace

void cutLayer(Layer& layer, const CutMesh& cut, bool singlePrecision) {
	FaceCutter faces(layer, cut); // what they were
	addVertices(layer, cut, singlePrecision);
	faces.cut();
	layer.facesChanged();
}

void labelPanels(Layer& layer, const CutResult& result, const std::vector<int>& faceOfTriangle) {
	CMeshO& mesh = layer.mesh();
	layer.enableFaceQuality();
	for (CFaceO& face : mesh.face)
		face.Q() = -1;
	for (std::size_t t = 0; t < faceOfTriangle.size(); ++t)
		mesh.face[std::size_t(faceOfTriangle[t])].Q() = static_cast<host::Scalar>(result.mesh.panel[t]);
	const auto write = [&](const char* name, auto elsewhere, const auto& valueOf) {
		auto values = faceAttribute(mesh, name, elsewhere);
		for (std::size_t t = 0; t < faceOfTriangle.size(); ++t)
			values[std::size_t(faceOfTriangle[t])] = valueOf(result.mesh.panel[t]);
	};
	const auto writeNumber = [&](const char* name, double elsewhere, const auto& valueOf) {
		write(name, static_cast<host::Scalar>(elsewhere), [&](int panel) {
			return narrowed<host::Scalar>(valueOf(result.report.panels[std::size_t(panel)]));
		});
	};
	write("panel", host::Scalar(-1), [](int panel) { return static_cast<host::Scalar>(panel); });
	writeNumber("panel_status", -1, [](const CutPanel& panel) {
		return static_cast<int>(panel.developable ? Status::Converged : Status::NeedsCut);
	});
	writeNumber("panel_reason", 0, [](const CutPanel& panel) { return static_cast<int>(panel.reason); });
	writeNumber("panel_nearest_developable", 0, [](const CutPanel& panel) {
		return panel.reason == Reason::TooFar ? panel.maxDisplacement : 0;
	});
	writeNumber("panel_neighbour", -1, [](const CutPanel& panel) { return panel.neighbour; });
	writeNumber("panel_border_overlaps", 0, [](const CutPanel&) { return 0; });
	writeNumber("panel_stretch", -1, [](const CutPanel&) { return -1; }); // not measured
	writeNumber("panel_curvature_before", 0, [](const CutPanel& panel) { return panel.curvatureBefore; });
	writeNumber("panel_curvature", 0, [](const CutPanel& panel) { return panel.curvatureAfter; });
	writeNumber("panel_max_angle_defect", 0, [](const CutPanel& panel) { return panel.maxAngleDefect; });
	writeNumber("panel_mean_displacement", 0, [](const CutPanel& panel) { return panel.meanDisplacement; });
	writeNumber("panel_max_displacement", 0, [](const CutPanel& panel) { return panel.maxDisplacement; });
	using Point = vcg::Point3<host::Scalar>;
	const auto writePoint = [&](const char* name, auto CutPanel::*point) {
		write(name, Point(0, 0, 0), [&](int panel) {
			const Eigen::Vector3d& at = result.report.panels[std::size_t(panel)].*point;
			return Point(narrowed<host::Scalar>(at[0]), narrowed<host::Scalar>(at[1]),
						 narrowed<host::Scalar>(at[2]));
		});
	};
	writePoint("panel_worst_point", &CutPanel::worstPoint);
	writePoint("panel_seam_point", &CutPanel::seamPoint);
}

void colourPanels(Layer& layer, const CutResult& result, const std::vector<int>& faceOfTriangle) {
	layer.enableFaceColours();
	for (std::size_t t = 0; t < faceOfTriangle.size(); ++t)
		layer.mesh().face[std::size_t(faceOfTriangle[t])].C() = paint(result.mesh.panel[t]);
}

} // namespace developable::plugin
