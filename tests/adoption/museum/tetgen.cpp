// Delaunay cells by TetGen: tetgen SITES 3 prints a cell a line.
#define TETLIBRARY
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <tetgen.h>

int main(int, char** arguments) {
    std::ifstream file(arguments[1]);
    std::vector<double> numbers;
    for (std::string word; file >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    tetgenio in;
    in.numberofpoints = static_cast<int>(numbers.size() / 3);
    in.pointlist = new REAL[numbers.size()];
    for (std::size_t k = 0; k < numbers.size(); ++k) in.pointlist[k] = numbers[k];
    tetgenio out;
    char quiet[] = "Q";
    try {
        tetrahedralize(quiet, &in, &out);
    } catch (int) {
        return 1;
    }
    for (int k = 0; k < out.numberoftetrahedra; ++k) {
        const int* cell = out.tetrahedronlist + 4 * k;
        std::printf("%d %d %d %d\n", cell[0], cell[1], cell[2], cell[3]);
    }
}
