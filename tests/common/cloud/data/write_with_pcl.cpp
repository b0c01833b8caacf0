// Writes the sample clouds of this folder with PCL's own writers (README.md).
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

int main() {
  pcl::PointCloud<pcl::PointXYZINormal> cloud;
  for (int i = 0; i < 100; ++i) {
    pcl::PointXYZINormal p;
    p.x = 0.25f * static_cast<float>(i) - 10.0f;
    p.y = 0.5f * static_cast<float>(i * 7 % 13);
    p.z = 0.125f * static_cast<float>(i % 5) - 0.5f;
    p.intensity = static_cast<float>(i);
    p.normal_z = 1.0f;
    cloud.push_back(p);
  }
  pcl::PCDWriter pcd;
  pcd.writeASCII("pcl_ascii.pcd", cloud);
  pcd.writeBinary("pcl_binary.pcd", cloud);
  pcd.writeBinaryCompressed("pcl_compressed.pcd", cloud);
  pcl::PLYWriter ply;
  ply.write("pcl_ascii.ply", cloud, false);
  ply.write("pcl_binary.ply", cloud, true);
}
