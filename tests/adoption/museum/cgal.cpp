// Regular triangulations by CGAL: cgal SITES DIMENSION prints a face a line. A last number is a
// weight.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plane = CGAL::Regular_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<
                CGAL::Triangulation_vertex_base_with_info_2<
                    int, Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>,
                CGAL::Regular_triangulation_face_base_2<Kernel>>>;
using Space = CGAL::Regular_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<
                CGAL::Triangulation_vertex_base_with_info_3<
                    int, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>,
                CGAL::Regular_triangulation_cell_base_3<Kernel>>>;

int main(int, char** arguments) {
    std::ifstream file(arguments[1]);
    const bool in_space = std::string(arguments[2]) == "3";
    std::vector<std::pair<Plane::Weighted_point, int>> plane;
    std::vector<std::pair<Space::Weighted_point, int>> space;
    int number = 0;
    for (std::string line; std::getline(file, line); ++number) {
        std::istringstream words(line);
        std::vector<double> x;
        for (std::string word; words >> word;) x.push_back(std::strtod(word.c_str(), nullptr));
        x.resize(4);
        if (in_space)
            space.push_back({{{x[0], x[1], x[2]}, x[3]}, number});
        else
            plane.push_back({{{x[0], x[1]}, x[2]}, number});
    }
    if (in_space) {
        const Space made(space.begin(), space.end());
        for (auto cell = made.finite_cells_begin(); cell != made.finite_cells_end(); ++cell)
            std::printf("%d %d %d %d\n", cell->vertex(0)->info(), cell->vertex(1)->info(),
                        cell->vertex(2)->info(), cell->vertex(3)->info());
    } else {
        const Plane made(plane.begin(), plane.end());
        for (auto face = made.finite_faces_begin(); face != made.finite_faces_end(); ++face)
            std::printf("%d %d %d\n", face->vertex(0)->info(), face->vertex(1)->info(),
                        face->vertex(2)->info());
    }
}
