#pragma once

#include <vector>

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include "voronaut/benchmarks/micro/peers/measured_scan.h"

namespace voronaut::micro {

// PCL's Euclidean cluster extraction of a single scan; nothing is kept between scans.
class PclClustering {
 public:
  explicit PclClustering(double link_distance_m) {
    extraction_.setClusterTolerance(link_distance_m);
    extraction_.setMinClusterSize(1);
  }

  void insert(const MeasuredScan& scan) {
    clusters_.clear();
    if (scan.returns_world.empty()) return;
    const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    for (const Vec2& p : scan.returns_world) {
      cloud->push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 0});
    }
    const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
    tree->setInputCloud(cloud);
    extraction_.setSearchMethod(tree);
    extraction_.setInputCloud(cloud);
    extraction_.extract(clusters_);
  }
  std::size_t size() const { return clusters_.size(); }

 private:
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction_;
  std::vector<pcl::PointIndices> clusters_;
};

}  // namespace voronaut::micro
