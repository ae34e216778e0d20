// SPDX-License-Identifier: GPL-3.0-or-later
// normal_clusters.cpp: Lloyd's iteration over planes.
#include "normal_clusters.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

namespace developable::detail {

namespace {

class Clusters {
public:
	Clusters(const CutSurface& surface, const std::vector<int>& triangles)
		: surface_(surface), triangles_(triangles), local_(surface.assembly().triangleCount(), -1),
		  label_(triangles.size(), -1) {
		for (std::size_t i = 0; i < triangles.size(); ++i)
			local_[triangles[i]] = static_cast<int>(i);
		Eigen::Vector3d mean = Eigen::Vector3d::Zero();
		double area = 0; // without it the mean of a large surface would have no digits left for the normals
		for (const int t : triangles) {
			mean += surface.areas()[t] * surface.normals().col(t);
			area += surface.areas()[t];
		}
		proxies_ = {mean / area};
		seeds_ = {leastDistorted(0, triangles_)};
		grow();
	}

	int count() const { return static_cast<int>(seeds_.size()); }
	const std::vector<int>& labels() const { return label_; }

	/// A Lloyd sweep: proxies and seeds from the clusters, clusters from them.
	void sweep() {
		fitProxies();
		for (int cluster = 0; cluster < count(); ++cluster)
			seeds_[cluster] = leastDistorted(cluster, membersOf(cluster));
		grow();
	}

	/// A seed where a cluster deviates most, in every cluster that deviates by more than so much, or, where
	/// none does, in the one that deviates most. \return whether there was any
	bool addSeeds(double greatestDeviation, int leastCount, int mostCount) {
		fitProxies();
		const std::vector<double> deviations = deviationOfClusters();
		const int before = count();
		for (int cluster = 0; cluster < before && count() < mostCount; ++cluster)
			if (deviations[cluster] > greatestDeviation)
				addSeedIn(cluster);
		if (count() == before && before < leastCount)
			addSeedIn(int(std::max_element(deviations.begin(), deviations.end()) - deviations.begin()));
		if (count() == before)
			return false;
		grow();
		return true;
	}

private:
	double deviation(int triangle, int cluster) const {
		return (surface_.normals().col(triangle) - proxies_[cluster]).squaredNorm();
	}

	std::vector<int> membersOf(int cluster) const {
		std::vector<int> members;
		for (std::size_t i = 0; i < triangles_.size(); ++i)
			if (label_[i] == cluster)
				members.push_back(triangles_[i]);
		return members;
	}

	int leastDistorted(int cluster, const std::vector<int>& members) const {
		return *std::min_element(members.begin(), members.end(),
								 [&](int a, int b) { return deviation(a, cluster) < deviation(b, cluster); });
	}

	void fitProxies() {
		std::fill(proxies_.begin(), proxies_.end(), Eigen::Vector3d::Zero());
		for (std::size_t i = 0; i < triangles_.size(); ++i)
			proxies_[label_[i]] += surface_.areas()[triangles_[i]] * surface_.normals().col(triangles_[i]);
		for (Eigen::Vector3d& proxy : proxies_)
			proxy.normalize();
	}

	std::vector<double> deviationOfClusters() const {
		std::vector<double> sums(count(), 0), areas(count(), 0);
		for (std::size_t i = 0; i < triangles_.size(); ++i) {
			const double area = surface_.areas()[triangles_[i]];
			sums[label_[i]] += area * deviation(triangles_[i], label_[i]);
			areas[label_[i]] += area;
		}
		for (int cluster = 0; cluster < count(); ++cluster)
			sums[cluster] /= areas[cluster];
		return sums;
	}

	void addSeedIn(int cluster) {
		const std::vector<int> members = membersOf(cluster);
		if (members.size() < 2)
			return;
		const auto farthestFrom = [&](const Eigen::Vector3d& normal) {
			return *std::max_element(members.begin(), members.end(), [&](int a, int b) {
				return (surface_.normals().col(a) - normal).squaredNorm() <
					   (surface_.normals().col(b) - normal).squaredNorm();
			});
		};
		int seed = farthestFrom(proxies_[cluster]);
		if (seed == seeds_[cluster]) // all are equally far from a mean of nothing
			seed = farthestFrom(surface_.normals().col(seed));
		if (seed == seeds_[cluster])
			return;
		seeds_.push_back(seed);
		proxies_.push_back(surface_.normals().col(seed));
	}

	void grow() {
		using Step = std::tuple<double, int, int>; // distortion, triangle, cluster
		std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
		std::fill(label_.begin(), label_.end(), -1);
		const auto spread = [&](int triangle, int cluster) {
			label_[local_[triangle]] = cluster;
			for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
				const int other = surface_.across(h) < 0 ? -1 : triangleOf(surface_.across(h));
				if (other >= 0 && local_[other] >= 0 && label_[local_[other]] < 0)
					front.emplace(surface_.areas()[other] * deviation(other, cluster), other, cluster);
			}
		};
		for (int cluster = 0; cluster < count(); ++cluster)
			label_[local_[seeds_[cluster]]] = cluster;
		for (int cluster = 0; cluster < count(); ++cluster)
			spread(seeds_[cluster], cluster);
		while (!front.empty()) {
			const auto [distortion, triangle, cluster] = front.top();
			front.pop();
			if (label_[local_[triangle]] < 0)
				spread(triangle, cluster);
		}
	}

	const CutSurface& surface_;
	const std::vector<int>& triangles_;
	std::vector<int> local_; // per triangle of the surface, its number among those, or -1
	std::vector<int> label_;
	std::vector<int> seeds_;
	std::vector<Eigen::Vector3d> proxies_;
};

} // namespace

std::vector<int> normalClusters(const CutSurface& surface, const std::vector<int>& triangles,
								const ClusterOptions& options) {
	Clusters clusters(surface, triangles);
	while (clusters.addSeeds(options.greatestDeviation, options.leastClusters, options.mostClusters))
		for (int sweep = 0; sweep < options.sweeps; ++sweep)
			clusters.sweep();
	return clusters.labels();
}

} // namespace developable::detail
