// What OctoMap needs for the scans that asbuilt carves: one insertPointCloud a station, lazily and discretised, its
// fastest way. Input: lines "station ox oy oz x y z" of returns, sorted by station. Used by scripts/bench/5-voxels.sh.
//
//   insert VOXEL [lazy|discretised] < returns.txt
#include <octomap/octomap.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

struct Station {
    octomap::point3d origin;
    octomap::Pointcloud cloud;
};

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: insert VOXEL [lazy|discretised] < returns.txt\n");
        return 2;
    }
    const double voxel = std::atof(argv[1]);
    const bool discretise = argc < 3 || std::string(argv[2]) == "discretised";
    std::vector<Station> stations;
    long last = -1, station;
    double o[3], p[3];
    size_t rays = 0;
    while (std::scanf("%ld %lf %lf %lf %lf %lf %lf", &station, &o[0], &o[1], &o[2], &p[0], &p[1], &p[2]) == 7) {
        if (station != last) {
            stations.push_back({octomap::point3d(o[0], o[1], o[2]), {}});
            last = station;
        }
        stations.back().cloud.push_back(p[0], p[1], p[2]);
        ++rays;
    }
    octomap::OcTree tree(voxel);
    const auto start = std::chrono::steady_clock::now();
    for (const Station& s : stations) tree.insertPointCloud(s.cloud, s.origin, -1.0, true, discretise);
    tree.updateInnerOccupancy();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double memory = tree.memoryUsage() / 1e9;
    size_t occupied = 0, free = 0;
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
        const size_t side = 1u << (tree.getTreeDepth() - leaf.getDepth());
        (tree.isNodeOccupied(*leaf) ? occupied : free) += side * side * side;
    }
    std::printf("%zu rays, %.2f s, %.3f M rays/s, %.2f GB, %zu occupied, %zu free\n", rays, seconds,
                rays / seconds / 1e6, memory, occupied, free);
    return 0;
}
