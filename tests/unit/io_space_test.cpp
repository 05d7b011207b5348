/// Sites of space from text, JSON, atoms and meshes; tessellations of space to JSON, CSV, OBJ and
/// VTK.

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../../tool/generate/generate.hpp"
#include "../../tool/io/elements.hpp"
#include "../../tool/io/errors.hpp"
#include "../../tool/io/read_sites.hpp"
#include "../../tool/io/read_tessellation.hpp"
#include "../../tool/io/write_sites.hpp"
#include "../../tool/io/write_tessellation.hpp"
#include "../../triangulation/space/triangulate.hpp"

#include "io_refusal.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

using Sites = std::vector<Site3>;

const ReadOptions in_space = {.dimension = 3};

SitesFile read(std::string_view contents, const ReadOptions& options = {}) {
    const test::Scratch scratch;
    return read_sites(scratch.file("f", contents), options);
}

ReadOptions as(SitesInput input) {
    return {.input = input};
}

/// The error message that the contents give, without the path.
std::string error(std::string_view contents, const ReadOptions& options = {}) {
    return test::refusal(contents,
                         [&](const std::string& path) { return read_sites(path, options); });
}

/// Whether the note, which begins with the path, ends so.
void expect_note(const SitesFile& file, std::string_view end) {
    EXPECT_TRUE(file.note.ends_with(end)) << file.note;
}

const std::string word =
    " is not a number; write a decimal or hexadecimal float, such as 1.5, -2e-3 or 0x1.8p-3";

TEST(TextSitesInSpace, AreToldByHeaderColumnsOrDimension) {
    const SitesFile file = read("x y z r\n1 2 3 4\n5 6 7 0\n");
    EXPECT_EQ(file.dimension, 3);
    EXPECT_EQ(file.in_space, (Sites{{1, 2, 3, 4}, {5, 6, 7, 0}}));
    EXPECT_TRUE(file.sites.empty());
    EXPECT_EQ(read("1 2 3 4\n", in_space).in_space, (Sites{{1, 2, 3, 4}}));
    EXPECT_EQ(read("1,2,3\n", in_space).in_space, (Sites{{1, 2, 3, 0}}));
    EXPECT_EQ(read("1 2 3\n").dimension, 2);
    EXPECT_EQ(read("x y z r\n1 2 3 4\n", {.dimension = 2}).sites, (std::vector<Site>{{1, 2, 4}}));
    EXPECT_EQ(read("1 2 3 4 5\n", {.columns = {"5", "4", "3", "2"}}).in_space,
              (Sites{{5, 4, 3, 2}}));
    EXPECT_EQ(read("a,x,y,z\nq,1,2,3\n", {.columns = {"x", "y", "Z"}}).in_space,
              (Sites{{1, 2, 3, 0}}));
    EXPECT_EQ(read("a,x,y,h\nq,1,2,3\n", {.columns = {"x", "y", "h"}}).sites,
              (std::vector<Site>{{1, 2, 3}}));
    EXPECT_EQ(read("9,1,2,3\n", {.columns = {"2", "3", "4"}, .dimension = 3}).in_space,
              (Sites{{1, 2, 3, 0}}));
}

TEST(TextSitesInSpace, TakeTheColumnsThatAHeaderNames) {
    EXPECT_EQ(read("radius,z,y,x\n4,3,2,1\n").in_space, (Sites{{1, 2, 3, 4}}));
    const SitesFile weighted = read("n;Y;weight;X;Z\na, b;2;-4;1;3\n");
    EXPECT_EQ(weighted.in_space, (Sites{{1, 2, 3, -4}}));
    EXPECT_EQ(weighted.third, WeightIs::weight);
    EXPECT_EQ(weighted.note, "");
    ASSERT_TRUE(weighted.first_negative);
    EXPECT_EQ(weighted.first_negative->line, 2);
    EXPECT_EQ(weighted.first_negative->column, 8);
    expect_note(read("x,y,z,mass\n1,2,3,4\n"),
                "f:1: 'mass' is left out: no radius, or it would be called r, radius or weight. "
                "--columns 1,2,3 leaves out all others without a word");
    expect_note(read("x,y,z,n,m\n1,2,3,4,5\n"),
                "f:1: 'n', 'm' are left out: no radius, or it would be called r, radius or weight. "
                "--columns 1,2,3 leaves out all others without a word");
}

TEST(TextSitesInSpace, RefuseWhatIsWrong) {
    EXPECT_EQ(error("x y z r\n1 2 3 4\n1 2 three 4\n"), "3:5: 'three'" + word);
    EXPECT_EQ(error("x y z r\n1 2 3 nan\n"),
              "2:7: 'nan' is not a finite number; write a finite one");
    EXPECT_EQ(error("x y z r\n1 2\n"), "2:4: 2 columns, but the header names 4; write as many");
    EXPECT_EQ(error("x y z r\n1 2 3 4 5\n"),
              "2:9: 5 columns, but the header names 4; write as many");
    EXPECT_EQ(error("1 2\n", in_space),
              "1:4: two columns; a site in space has at least three: x y z [r]");
    EXPECT_EQ(error("1\n", in_space),
              "1:2: one column; a site in space has at least three: x y z [r]");
    EXPECT_EQ(
        error("1 2 3 4 5\n", in_space),
        "1:9: more than four columns; a site in space is x y z [r], or name the columns x, y, "
        "z and r (or radius, weight) in a first line, or choose with --columns, as in "
        "--columns 1,2,3");
    EXPECT_EQ(error("1,2,3,\n", in_space),
              "1:7: an empty column; write a number or remove the separator");
    EXPECT_EQ(
        error("x y\n1 2\n", in_space),
        "1:1: the header does not name x, y and z, but 'x', 'y'; choose them with --columns, as in "
        "--columns 1,2,3");
    EXPECT_EQ(error("x y z z\n1 2 3 4\n"), "1:7: a second column z; name one");
    EXPECT_EQ(error("x y z r weight\n1 2 3 4 5\n"),
              "1:9: a second column of radii or weights; name one column r, radius or weight");
    EXPECT_EQ(error("1 2 3 4\n", {.columns = {"1", "2", "3", "1"}}),
              "1:1: column 1 is chosen twice; x, y, z and r are different columns");
    EXPECT_EQ(error("x y z\n"), "1:1: a header and no site; write one site a line: x y z [r]");
    EXPECT_EQ(error("", in_space), "1:1: no site in this file; write one site a line: x y z [r]");
    EXPECT_EQ(error("1 2 3 4\n"),
              "1:7: more than three columns; a site is x y [r], or name the columns x, y and r (or "
              "radius, weight) in a first line, or choose with --columns, as in --columns 1,2; "
              "--dimension 3 reads x y z [r]");
}

TEST(TextSitesInSpace, AreMissedWhereNoColumnIsCalledZ) {
    const SitesFile beside_radius = read("x,y,zz,r\n1,2,3,4\n");
    EXPECT_EQ(beside_radius.sites, (std::vector<Site>{{1, 2, 4}}));
    expect_note(beside_radius,
                "f:1: 'zz' is left out: sites lie in space where it is called z. --dimension 3 "
                "--columns 1,2,3,4 takes it for z, --columns 1,2,4 leaves it out without a word");
    EXPECT_EQ(read("x,y,zz,r\n1,2,3,4\n", {.columns = {"1", "2", "3", "4"}}).in_space,
              (Sites{{1, 2, 3, 4}}));
    const SitesFile alone = read("x_um,y_um,z_um\n1,2,3\n");
    EXPECT_EQ(alone.sites, (std::vector<Site>{{1, 2, 0}}));
    expect_note(alone,
                "f:1: 'z_um' is left out: sites lie in space where it is called z. --dimension 3 "
                "--columns 1,2,3 takes it for z, --columns 1,2 "
                "leaves it out without a word");
    for (const char* name : {"pz", "pos.z", "Z [m]", "z1", "center_z"})
        EXPECT_NE(read(std::string("x,y,") + name + ",r\n1,2,3,4\n").note, "") << name;
    for (const char* name : {"zone", "size", "m", "", "fizz"})
        EXPECT_EQ(read(std::string("x,y,") + name + ",r\n1,2,3,4\n").note, "") << name;
    EXPECT_EQ(read("x,y,zz,r\n1,2,3,4\n", {.dimension = 2}).note, "");
    EXPECT_EQ(error("a,b,c,d\n1,2,3,4\n"),
              "1:1: none of the columns 'a', 'b', 'c', 'd' is called x or y; choose them with "
              "--columns, as in --columns 1,2, or --columns 1,2,3,4 for x, y, z and r in space");
    expect_note(
        read("x,y,zz,m\n1,2,3,4\n"),
        "f:1: 'zz', 'm' are left out: sites lie in space where it is called z. --columns 1,2 "
        "leaves them out without a word");
}

TEST(Sites, SayWhichFormatIsNotRead) {
    struct Beginning {
        const char* text;
        const char* name;
    };
    const std::vector<Beginning> beginnings = {
        {"data_1ABC\n#\n_entry.id 1ABC\n", "CIF"},
        {"# made by hand\ndata_1ABC\n", "CIF"},
        {"<?xml version=\"1.0\"?>\n<kml xmlns=\"\">\n", "KML"},
        {"\n  <gpx version=\"1.1\">\n", "GPX"},
        {"<?xml version=\"1.0\"?>\n<data/>\n", "XML"},
        {"<VTKFile type=\"PolyData\">\n", "VTK's XML"},
        {"# vtk DataFile Version 3.0\ntitle\nASCII\n", "VTK's legacy format"},
        {"solid cube\n facet normal 0 0 1\n", "STL"},
        {"OFF\n4 4 6\n0 0 0\n", "OFF"},
        {"ply\nformat ascii 1.0\n", "PLY"},
        {"@<TRIPOS>MOLECULE\nx\n", "MOL2"},
        {"# one\n@<TRIPOS>MOLECULE\nx\n", "MOL2"},
        {"ITEM: TIMESTEP\n0\n", "a dump of LAMMPS"},
        {"LAMMPS data file\n\n2 atoms\n", "LAMMPS' data"},
        {"polymer\n\n2 atoms\n1 atom types\n0 1 xlo xhi\n", "LAMMPS' data"},
        {"CRYST1   10.000   10.000\n", "PDB"},
        {"ATOM      1  N   ALA A   1      11.104   6.134  -6.504  1.00  0.00           N  \n",
         "PDB or PQR"},
        {"2\nwater\nO 0 0 0\nH 0 0 1\n", "XYZ"},
        {"Two waters\n6\n    1SOL     OW    1   0.500   1.500   1.600\n", "GRO"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "OBJ"},
        {"Si2\n1.0\n1 0 0\n0 1 0\n0 0 1\nSi\n2\nDirect\n0 0 0\n", "POSCAR"},
        {"POINT (1 2)\nPOINT (3 4)\n", "WKT"},
        {"POLYGON((0 0, 1 0, 1 1, 0 0))\n", "WKT"},
    };
    for (const Beginning& each : beginnings)
        for (const ReadOptions& options : {ReadOptions(), in_space})
            EXPECT_TRUE(error(each.text, options)
                            .starts_with("1:1: this is " + std::string(each.name) + ", which "))
                << each.text << error(each.text, options);
    // Headers and sites that begin alike.
    for (const char* text :
         {"POINT_X POINT_Y\n1 2\n", "OFFSET,x,y\n1,1,2\n", "2 1\n3 4\n5 6\n", "v,x,y\n1,1,2\n",
          "ply,x,y\n1,1,2\n", "solid,x,y\n1,1,2\n", "data_id,x,y\n1,1,2\n"})
        EXPECT_GE(read(text).sites.size(), 1U) << text;
    for (const auto& [mark, name] : std::map<std::string, std::string>{
             {"\xFD\x37zXZ", "xz"}, {"\x28\xB5\x2F\xFD", "zstd"}, {"PK\x03\x04", "zip"}}) {
        for (const SitesInput input : {SitesInput::text, SitesInput::pdb, SitesInput::ply})
            EXPECT_EQ(error(mark + std::string(3, '\0'), as(input)),
                      " this is compressed by " + name +
                          ", and of compressed files those of gzip alone are read, where they hold "
                          "text; decompress it first");
    }
}

TEST(JsonSitesInSpace, AreToldByTheFirstSite) {
    EXPECT_EQ(read("[[1,2,3,4],\n[5,6,7]]").in_space, (Sites{{1, 2, 3, 4}, {5, 6, 7, 0}}));
    EXPECT_EQ(read("[[1,2,3],[4,5]]").dimension, 2);
    EXPECT_EQ(read("[[1,2,3],[4,5,6,7]]", in_space).in_space, (Sites{{1, 2, 3, 0}, {4, 5, 6, 7}}));
    EXPECT_EQ(read("[[\"a\",1,2,3,4]]", {.columns = {"5", "4", "3", "2"}}).in_space,
              (Sites{{4, 3, 2, 1}}));
    const SitesFile negative = read("[[-1,-2,-3,4],\n[1,2,3,-4]]");
    ASSERT_TRUE(negative.first_negative);
    EXPECT_EQ(negative.first_negative->line, 2);
    EXPECT_EQ(negative.first_negative->column, 8);
}

TEST(JsonSitesInSpace, RefuseWhatIsWrong) {
    const std::string plane = "; sites are [[x, y, r], ...] with finite numbers";
    const std::string space = "; sites are [[x, y, z, r], ...] with finite numbers";
    EXPECT_EQ(error("[[1,2,3],\n[1,2,3,4]]"),
              "2:8: a fourth number in a site, where the first site has no more than three; with "
              "--dimension 3 the third is z" +
                  plane);
    EXPECT_EQ(error("[[1,2,3,4]]", {.dimension = 2}),
              "1:9: a fourth number in a site, as those in space have it; those of the plane are "
              "wanted here" +
                  plane);
    EXPECT_EQ(error("[[1,2,3,4,5]]", in_space), "1:11: a fifth number in a site" + space);
    EXPECT_EQ(error("[[1,2,3,4],\n[1,2]]"), "2:1: a site that ends before x, y and z" + plane);
    EXPECT_EQ(error("[]", in_space), "1:1: no site in this file" + space);
    EXPECT_EQ(error("[]"), "1:1: no site in this file" + plane);
}

TEST(XyzSites, ReadAtoms) {
    const SitesFile file =
        read("3\nwater\nO 0 0 0 1.52\nH 0.96 0 0 1.2\nH -0.24 0.93 0\n\n", as(SitesInput::xyz));
    EXPECT_EQ(file.dimension, 3);
    EXPECT_EQ(file.in_space, (Sites{{0, 0, 0, 0}, {0.96, 0, 0, 0}, {-0.24, 0.93, 0, 0}}));
    expect_note(
        file,
        "f: no atom has a radius, and all radii are 0; a fifth word is no radius, for nothing "
        "says so, and is left out (2 of 3 atoms); say it in the comment, as in "
        "Properties=species:S:1:pos:R:3:radius:R:1, or with --read-as text --skip-lines 2 "
        "--columns 2,3,4,5");
    EXPECT_EQ(read("2\nwater\nO 0 0 0 1.52\nH 0.96 0 0 1.2\n",
                   {.columns = {"2", "3", "4", "5"}, .skipped_lines = 2})
                  .in_space,
              (Sites{{0, 0, 0, 1.52}, {0.96, 0, 0, 1.2}}));
    const SitesFile frames = read(
        "1\nProperties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1 Time=0\nA 1 2 3 9 9 9 4 0\n"
        "1\nLattice=\"1 0 0\" Properties=id:I:1:radius:R:1:pos:R:3 Time=1\n7 4 5 6 7\n",
        as(SitesInput::xyz));
    EXPECT_EQ(frames.in_space, (Sites{{5, 6, 7, 4}}));
    expect_note(frames,
                "f: of 2 frames the last one is read; the periodic box is left out, and the atoms "
                "are in all of space");
    const auto note_of = [](std::string_view comment) {
        return read(fmt::format("1\n{} Properties=pos:R:3:radius:R:1\n1 2 3 4\n", comment),
                    as(SitesInput::xyz))
            .note;
    };
    EXPECT_EQ(note_of("Lattice=\"9 0 0 0 9 0 0 0 9\" pbc=\"F F F\""), "");
    EXPECT_NE(note_of("Lattice=\"9 0 0 0 9 0 0 0 9\" pbc=\"F F T\""), "");
    EXPECT_EQ(note_of("pbc=\"T T T\""), "") << "of what box";
    EXPECT_EQ(read("1\nProperties=Pos:R:3:Radius:R:1\n1 2 3 4\n", as(SitesInput::xyz)).in_space,
              (Sites{{1, 2, 3, 4}}));
    // The key is a word of its own; its value is as others write it, too.
    for (const char* extended :
         {"Properties = radius:R:1:pos:R:3", "Properties=\"radius:R:1:pos:R:3\" pbc='T T F'",
          "name=\"no Properties=pos:R:3 here\" properties='radius:R:1:pos:R:3'",
          "Lattice=\"1 0 0\"Properties=radius:R:1:pos:R:3", "it's Properties\t=radius:R:1:pos:R:3"})
        EXPECT_EQ(read(fmt::format("1\n{}\n4 1 2 3\n", extended), as(SitesInput::xyz)).in_space,
                  (Sites{{1, 2, 3, 4}}))
            << extended;
    for (const char* plain : {"MyProperties=radius:R:1:pos:R:3", "Properties", "= Properties",
                              "\"Properties=radius:R:1:pos:R:3\"", "\"Properties\"=pos:R:3"})
        EXPECT_EQ(read(fmt::format("1\n{}\n4 1 2 3\n", plain), as(SitesInput::xyz)).in_space,
                  (Sites{{1, 2, 3, 0}}))
            << plain;
    expect_note(read("1\n\nO 1 2 3\n", as(SitesInput::xyz)),
                "f: no atom has a radius, and all radii are 0");
    expect_note(read("1\n\nO 1 2 3 4\n1\n\nO 1 2 3\n", as(SitesInput::xyz)),
                "f: of 2 frames the last one is read; no atom has a radius, and all radii are 0");
}

TEST(XyzSites, RefuseWhatIsWrong) {
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::xyz));
    };
    const std::string advice =
        "; an XYZ file is the number of atoms, a comment, and a line each: element x y z [radius]";
    EXPECT_EQ(wrong("1 2 3\n4 5 6\n"),
              "1:3: the number of atoms stands alone in the first line of an XYZ file; where lines "
              "are x y z [r], say --read-as text --dimension 3");
    EXPECT_EQ(wrong("2\n\nO 0 0 0\nH 0 zero 0\n"), "4:5: 'zero'" + word);
    EXPECT_EQ(wrong("2\n\nO 0 0 0\nH 0 0\n"), "4:6: 3 words; an atom is element x y z [radius]");
    EXPECT_EQ(wrong("1\n\nO 0 0 0 1 2\n"),
              "3:11: more than element x y z radius; write no more, or say in the comment what it "
              "is, as in Properties=species:S:1:pos:R:3:...");
    EXPECT_EQ(wrong("2\n\nO 0 0 0\n"), "3:1: the file ends after 1 of 2 atoms" + advice);
    EXPECT_EQ(wrong("0\n\n"), "2:1: no atom in this file" + advice);
    EXPECT_EQ(wrong("1\n\nO 0 0 0\n0\n\n"), "5:1: no atom in the last of 2 frames" + advice);
    EXPECT_EQ(wrong(""), "1:1: no atom in this file" + advice);
    EXPECT_EQ(wrong("1\nProperties=species:S:1\nO\n"),
              "2:1: Properties without pos:R:3, the places of the atoms");
    for (const char* empty : {"Properties=", "Properties = ", "Properties=''"})
        EXPECT_EQ(wrong(fmt::format("1\n{}\nO 1 2 3\n", empty)),
                  "2:1: Properties without pos:R:3, the places of the atoms");
    EXPECT_EQ(wrong("1\nProperties=species:S:1:pos:R:3\nO 1 2 3 4\n"),
              "3:9: 5 words, but Properties name 4; write as many");
}

const std::string protein =
    "HEADER    TEST\n"
    "ATOM      1  N   ALA A   1      11.104   6.134  -6.504  1.00  0.00           N  \n"
    "ATOM      2  CA AALA A   1      11.639   6.071  -5.147  1.00  0.00           C  \n"
    "ATOM      3  CA BALA A   1      11.700   6.100  -5.200  1.00  0.00           C  \n"
    "ATOM      4 HG11 VAL A   2      13.500   7.700  -4.000  1.00  0.00\n"
    "HETATM    5 CA    CA A 101      14.000   7.700  -3.000  1.00  0.00          CA\n"
    "HETATM    6 FE   HEM A 102      10.000   3.700  -1.000\n"
    "ATOM      7 1HB  VAL A   2      13.500   7.700  -4.500  1.00  0.00      1ABC 123\n";

TEST(PdbSites, ReadAtomsWithTheRadiiOfTheirElements) {
    const SitesFile file = read(protein + "ENDMDL\n" + protein, as(SitesInput::pdb));
    EXPECT_EQ(file.dimension, 3);
    EXPECT_EQ(file.third, WeightIs::radius);
    EXPECT_EQ(file.in_space, (Sites{{11.104, 6.134, -6.504, 1.55},
                                    {11.639, 6.071, -5.147, 1.7},
                                    {13.5, 7.7, -4, 1.2},
                                    {14, 7.7, -3, 2.31},
                                    {10, 3.7, -1, 2.44},
                                    {13.5, 7.7, -4.5, 1.2}}));
    expect_note(
        file,
        "f: 1 alternate place of atoms and 7 atoms of models after the first one are left "
        "out; 3 atoms name no element, and are taken by name and residue for one: 1 Fe, 2 H");
}

TEST(PdbSites, KeepOneLetterOfAResidue) {
    // Two types of residue share a place, and an atom of either is called differently.
    const std::string shared =
        "ATOM      1  CB ASER A   9      10.000   1.000   2.000  0.50  0.00           C\n"
        "ATOM      2  CB BTHR A   9      11.000   1.000   2.000  0.50  0.00           C\n"
        "ATOM      3  OG ASER A   9      12.000   1.000   2.000  0.50  0.00           O\n"
        "ATOM      4  OG1BTHR A   9      13.000   1.000   2.000  0.50  0.00           O\n"
        "ATOM      5  C   SER A   9      14.000   1.000   2.000  1.00  0.00           C\n"
        "ATOM      6  CB BTHR A  10      15.000   1.000   2.000  0.50  0.00           C\n"
        "ATOM      7  CB ASER A  10      16.000   1.000   2.000  0.50  0.00           C\n";
    const SitesFile file = read(shared, as(SitesInput::pdb));
    EXPECT_EQ(file.in_space,
              (Sites{{10, 1, 2, 1.7}, {12, 1, 2, 1.52}, {14, 1, 2, 1.7}, {15, 1, 2, 1.7}}));
    expect_note(file, "f: 3 alternate places of atoms are left out");
}

TEST(PdbSites, RefuseLinesThatEndWithinANumber) {
    const std::string atom = "ATOM      1  N   ALA A   1      11.104   6.134  46.760";
    const auto cut = [&](std::size_t size) {
        return error(atom.substr(0, size), as(SitesInput::pdb));
    };
    const auto message = [](std::size_t size, std::size_t first) {
        return fmt::format(
            "1:{}: the line ends within columns {} to {}, and the number there may have lost "
            "digits; an atom of a PDB file is a line ATOM or HETATM with x, y and z in columns 31 "
            "to 54",
            size + 1, first, first + 7);
    };
    EXPECT_EQ(read(atom, as(SitesInput::pdb)).in_space, (Sites{{11.104, 6.134, 46.76, 1.55}}));
    for (std::size_t size = 49; size < 54; ++size) EXPECT_EQ(cut(size), message(size, 47)) << size;
    for (std::size_t size = 42; size < 46; ++size) EXPECT_EQ(cut(size), message(size, 39)) << size;
    for (std::size_t size = 33; size < 38; ++size) EXPECT_EQ(cut(size), message(size, 31)) << size;
    // A blank says that the number is whole.
    EXPECT_EQ(read(atom.substr(0, 46) + "   46.7 ", as(SitesInput::pdb)).in_space,
              (Sites{{11.104, 6.134, 46.7, 1.55}}));
}

TEST(PdbSites, RefuseWhatIsWrong) {
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::pdb));
    };
    const std::string advice =
        "; an atom of a PDB file is a line ATOM or HETATM with x, y and z in columns 31 to 54";
    EXPECT_EQ(wrong("HEADER\n"), "1:1: no atom in this file" + advice);
    EXPECT_EQ(wrong("ATOM      1  N\n"), "1:15: no number in columns 31 to 38" + advice);
    EXPECT_EQ(wrong("\nATOM      1  N   ALA A   1      11.104   six13  -6.504\n"),
              "2:42: 'six13'" + word);
    EXPECT_EQ(
        wrong("ATOM      1  X   UNK A   1      11.104   6.134  -6.504  1.00  0.00           X\n"),
        "1:77: no van der Waals radius is known of 'X'; give one, as in --radius X=2.1, or radii "
        "of "
        "all atoms in a PQR file");
    // Digits of one number would be another's.
    EXPECT_EQ(wrong("ATOM  16118 CA   GLN D 1000      23.700 -28.100 -33.400  1.00\n"),
              "1:31: x, y and z are to stand in columns 31 to 38, 39 to 46 and 47 to 54, and there "
              "stands '   23.700 -28.100 -33.40'; where a long number before them has moved them, "
              "move them back");
}

TEST(PdbSites, TakeElementsFromResiduesAndNames) {
    struct Atom {
        const char* name;  ///< columns 13 to 16
        const char* residue;
        const char* element;
    };
    const std::vector<Atom> atoms = {// Ions of CHARMM, Amber and others, in whatever column.
                                     {"SOD ", "SOD", "Na"},
                                     {" SOD", "SOD", "Na"},
                                     {"POT ", "POT", "K"},
                                     {"CLA ", "CLA", "Cl"},
                                     {"CAL ", "CAL", "Ca"},
                                     {"CES ", "CES", "Cs"},
                                     {"LIT ", "LIT", "Li"},
                                     {" ZN ", "ZN2", "Zn"},
                                     {"MG  ", " MG", "Mg"},
                                     {"Na+ ", "Na+", "Na"},
                                     {" K+ ", " K+", "K"},
                                     {"Cl- ", "Cl-", "Cl"},
                                     {"CIO ", "CIO", "Na"},
                                     {" NA ", " NA", "Na"},
                                     {" CL ", " CL", "Cl"},
                                     {" U  ", "  U", "U"},
                                     // Chlorophyll is no chloride.
                                     {"MG  ", "CLA", "Mg"},
                                     {" CHA", "CLA", "C"},
                                     // Names that begin in column 13 all the same.
                                     {"OG  ", "SER", "O"},
                                     {"CA  ", "ALA", "C"},
                                     {"CD  ", "GLU", "C"},
                                     {"HG  ", "SER", "H"},
                                     {"NE  ", "ARG", "N"},
                                     {"SG  ", "CYS", "S"},
                                     {"NH1 ", "ARG", "N"},
                                     {"HO5'", " DA", "H"},
                                     {"SE  ", "MSE", "Se"},
                                     {"1HB ", "ALA", "H"},
                                     {"OH2 ", "TIP", "O"},
                                     {"P   ", " DG", "P"},
                                     {" CA ", "GLY", "C"},
                                     {"HE21", "GLN", "H"},
                                     // Where the residue says nothing, the columns do.
                                     {"FE  ", "HEM", "Fe"},
                                     {" C1 ", "LIG", "C"},
                                     {"CL1 ", "LIG", "Cl"},
                                     {"C210", "LIG", "C"}};
    for (const auto& [name, residue, element] : atoms) {
        const SitesFile file =
            read(fmt::format("HETATM    1 {:4} {:>3} A   1       1.000   2.000   3.000\n", name,
                             residue),
                 as(SitesInput::pdb));
        EXPECT_EQ(file.in_space, (Sites{{1, 2, 3, *van_der_waals_radius(element)}}))
            << name << ' ' << residue;
        expect_note(file,
                    fmt::format("f: 1 atom names no element, and is taken by name and residue "
                                "for one: 1 {}",
                                element));
    }
}

TEST(PdbSites, TakeTheRadiiThatWereChosen) {
    const std::string two = std::string(
        "HETATM    1 MO1  ICS A 500       1.000   0.000   0.000  1.00  "
        "0.00          MO\nHETATM    2 PU1  ICS A 500       2.000   "
        "0.000   0.000  1.00  0.00          PU\n");
    EXPECT_EQ(read(two, {.input = SitesInput::pdb, .radii = {{"mo", 2.1}, {"pu", 2}}}).in_space,
              (Sites{{1, 0, 0, 2.1}, {2, 0, 0, 2}}));
    EXPECT_EQ(error(two, as(SitesInput::pdb)),
              "2:77: no van der Waals radius is known of 'PU'; give one, as in --radius Pu=2.1, or "
              "radii of all atoms in a PQR file");
}

TEST(PdbSites, TakeNoElementForAnother) {
    const auto of = [](std::string_view name, std::string_view element) {
        return fmt::format(
            "HETATM    1 {:4} OS  A   1       1.000   2.000   3.000  1.00  0.00{:>12}\n", name,
            element);
    };
    const auto refused = [](std::size_t column, std::string_view shown, std::string_view element) {
        return fmt::format(
            "1:{}: no van der Waals radius is known of '{}'; give one, as in --radius {}=2.1, or "
            "radii of all atoms in a PQR file",
            column, shown, element);
    };
    // Plutonium is no phosphorus, fermium no fluorine.
    EXPECT_EQ(error(of("PU", "PU"), as(SitesInput::pdb)), refused(77, "PU", "Pu"));
    EXPECT_EQ(error(of(" O", "FM"), as(SitesInput::pdb)), refused(77, "FM", "Fm"));
    EXPECT_EQ(error(of("PU", ""), as(SitesInput::pdb)), refused(13, "PU", "Pu"));
    EXPECT_EQ(error(of("FM", ""), as(SitesInput::pdb)), refused(13, "FM", "Fm"));
    // Two letters that are no element begin with one.
    EXPECT_EQ(read(of("OXT", ""), as(SitesInput::pdb)).in_space, (Sites{{1, 2, 3, 1.52}}));
}

TEST(PdbSites, AreThoseOfTheFirstModel) {
    const std::string atom =
        "ATOM      1  N   ALA A   1      11.104   6.134  46.760  1.00  0.00           N\n";
    for (const std::string_view between : {"ENDMDL\n", "END\n", "END   \n", "MODEL        2\n"}) {
        const SitesFile file =
            read("MODEL        1\n" + atom + std::string(between) + atom, as(SitesInput::pdb));
        EXPECT_EQ(file.in_space.size(), 1) << between;
        expect_note(file, "f: 1 atom of models after the first one is left out");
    }
}

TEST(PqrSites, AreThoseOfTheFirstModel) {
    const std::string atom = " ATOM 1 N ALA 1 1 2 3 -0.3 1.85\n";
    for (const std::string_view between : {"ENDMDL\n", "END\n", "MODEL 2\n"}) {
        const SitesFile file =
            read("MODEL 1\n" + atom + std::string(between) + atom + atom, as(SitesInput::pqr));
        EXPECT_EQ(file.in_space, (Sites{{1, 2, 3, 1.85}})) << between;
        expect_note(file, "f: 2 atoms of models after the first one are left out");
    }
}

TEST(PqrSites, RefuseWordsThatAreNotTheirs) {
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::pqr));
    };
    EXPECT_EQ(wrong("ATOM 1 N ALA A 1 1.5 2.5 3.5 0.15 1.85 7\n"),
              "1:40: 12 words; an atom has no more than 11: record, number, name, residue, chain, "
              "number, x, y, z, charge, radius");
    EXPECT_EQ(wrong("ATOM 1 N ALA A 1.5 2.5 3.5 4.5 0.15 1.85\n"),
              "1:16: '1.5' is no residue's number, which stands before the last five words: x, y, "
              "z, charge, radius");
    EXPECT_EQ(wrong("ATOM 1 N ALA 1 1 2 3 foo 1.85\n"), "1:22: 'foo'" + word);
    // With an insertion code, a sign, a chain.
    for (const std::string_view number : {"52A", "-3", "B1000", "A000"})
        EXPECT_EQ(read(fmt::format("ATOM 1 N ALA {} 1 2 3 0 1.85\n", number), as(SitesInput::pqr))
                      .in_space,
                  (Sites{{1, 2, 3, 1.85}}))
            << number;
}

TEST(PqrSites, ReadRadii) {
    const SitesFile file = read(
        "REMARK 1\nATOM 1 N ALA 1 1 2 3 -0.3 1.85\nHETATM 2 CA ALA A 1 4 5 6 0.21 2.275\nEND\n",
        as(SitesInput::pqr));
    EXPECT_EQ(file.in_space, (Sites{{1, 2, 3, 1.85}, {4, 5, 6, 2.275}}));
    EXPECT_EQ(file.third, WeightIs::radius);
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::pqr));
    };
    EXPECT_EQ(wrong("ATOM 1 N ALA 1 1 2 3 -0.3\n"),
              "1:26: 9 words; an atom is record, number, name, residue, [chain,] number, x, y, z, "
              "charge, radius");
    EXPECT_EQ(wrong("ATOM 1 N ALA A 1 1 2 3 -0.3\n"),
              "1:14: 'A' is no residue's number, which stands before the last five words: x, y, z, "
              "charge, radius");
    EXPECT_EQ(wrong("ATOM 1 N ALA 1 1 2 3 -0.3 -1\n"), "1:27: a negative radius; write 0 or more");
    EXPECT_EQ(wrong("ATOM 1 N ALA 1 1 2 z -0.3 1\n"), "1:20: 'z'" + word);
}

TEST(PlySites, ReadVertices) {
    const std::string head = "ply\nformat ascii 1.0\ncomment made by hand\n";
    const SitesFile file =
        read(head +
                 "element camera 1\nproperty float f\nelement vertex 2\nproperty float z\nproperty "
                 "double x\nproperty uchar red\nproperty float y\nproperty float weight\nelement "
                 "face 1\nproperty list uchar int vertex_indices\nend_header\n9\n3 1 255 2 -4\n"
                 "7 5 255 6 8\n3 0 1 1\n",
             as(SitesInput::ply));
    EXPECT_EQ(file.in_space, (Sites{{1, 2, 3, -4}, {5, 6, 7, 8}}));
    EXPECT_EQ(file.third, WeightIs::weight);
    ASSERT_TRUE(file.first_negative);
    EXPECT_EQ(file.first_negative->line, 16);
    const auto wrong = [&](std::string_view contents) {
        return error(contents, as(SitesInput::ply));
    };
    const std::string advice =
        "; a PLY file begins with ply, format ascii 1.0 or a binary one, and element vertex with "
        "properties x, y and z";
    EXPECT_EQ(wrong("1 2 3\n"), "1:1: this is no PLY file" + advice);
    EXPECT_EQ(wrong("ply\nformat binary 1.0\n"),
              "2:8: a format is ascii, binary_little_endian or binary_big_endian");
    EXPECT_EQ(wrong("ply\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                    "end_header\n1 2 3\n"),
              "6:1: the header has no line format ascii 1.0" + advice);
    EXPECT_EQ(wrong(head + "element vertex\n"), "4:9: an element is a line element NAME NUMBER");
    EXPECT_EQ(wrong(head + "element vertex 1\nproperty float x\nproperty float x\n"),
              "6:16: a second property x; leave one of them out");
    EXPECT_EQ(wrong(head + "element vertex 1\nproperty float radius\nproperty float weight\n"),
              "6:16: a second property of radii or weights; leave one of them out");
    EXPECT_EQ(wrong(head + "element vertex 1\nelement vertex 2\n"),
              "5:9: a second element vertex; leave one of them out");
    EXPECT_EQ(wrong(head + "vertices 3\n"),
              "4:1: 'vertices' cannot stand in the header of a PLY file; it ends with end_header");
    EXPECT_EQ(wrong(head + "element vertex 1\nproperty float x\nend_header\n1\n"),
              "6:1: no vertices with x, y and z" + advice);
    const std::string vertices =
        head +
        "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    EXPECT_EQ(wrong(vertices + "1 2 3\n"),
              "9:1: the file ends after 1 of 2 elements vertex" + advice);
    EXPECT_EQ(wrong(vertices + "1 2 3\n1 2\n"),
              "10:4: 2 numbers, but the header names 3 properties of a vertex");
    EXPECT_EQ(wrong(vertices + "1 2 3\n1 2 3x\n"), "10:5: '3x'" + word);
    EXPECT_EQ(wrong(vertices + "1 2 3\n4 5 6\n\n7 8 9\n"), "12:1: a line beyond the 2 vertices");
    // A vertex is not taken for a part of the header, nor for a face.
    const std::string mesh = head +
                             "element vertex 2\nproperty float x\nproperty float y\nproperty float "
                             "z\nelement face 1\nproperty list uchar int vertex_indices\n";
    EXPECT_EQ(wrong(mesh + "end_header 1 2 3\n4 5 6\n3 0 1 1\n"),
              "10:12: end_header stands alone in its line");
    EXPECT_EQ(wrong(mesh + "end_header\n1 2 3\n4 5 6\n7 8 9\n3 0 1 1\n"),
              "14:1: a line beyond the 1 elements face");
    EXPECT_EQ(wrong(mesh + "end_header\n1 2 3\n4 5 6\n"),
              "12:1: the file ends after 0 of 1 elements face" + advice);
    std::string elements;
    for (int i = 0; i < 1000; ++i) elements += "element e 1\n";
    EXPECT_EQ(wrong(head + elements + "element f 1\n"),
              "1004:1: more than 1000 elements; leave some out");
    EXPECT_EQ(wrong(head + "element vertex 1\nproperty doubel x\n"),
              "5:10: 'doubel' is no type of PLY's; for a number give double");
}

/// The bytes of a number, the least first, or the other way round.
template <class T>
std::string bytes_of(T value, bool is_big) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (is_big) std::ranges::reverse(bytes);
    return bytes;
}

TEST(PlySites, ReadBytes) {
    for (const bool is_big : {false, true}) {
        const std::string head = fmt::format(
            "ply\nformat binary_{}_endian 1.0\nelement vertex 3\nproperty uchar red\nproperty "
            "float "
            "z\nproperty double x\nproperty short y\nproperty int radius\nelement face 1\nproperty "
            "list uchar int vertex_indices\nend_header\n",
            is_big ? "big" : "little");
        std::string body;
        Sites expected;
        for (int i = 0; i < 3; ++i) {
            body += '\n' + bytes_of(0.1F * static_cast<float>(i), is_big) +
                    bytes_of(0.1 * i, is_big) +
                    bytes_of(static_cast<std::int16_t>(-300 * i), is_big) +
                    bytes_of(70'000 * i, is_big);
            expected.push_back({0.1 * i, -300.0 * i, 0.1F * static_cast<float>(i), 70'000.0 * i});
        }
        const std::string face = '\3' + std::string(12, '\0');
        EXPECT_EQ(read(head + body + face, as(SitesInput::ply)).in_space, expected);
        EXPECT_EQ(error(head + body.substr(0, body.size() - 1), as(SitesInput::ply)),
                  " the file ends after 2 of 3 vertices");
        std::string infinite = body;
        infinite.replace(5, 8, bytes_of(HUGE_VAL, is_big));
        EXPECT_EQ(error(head + infinite, as(SitesInput::ply)),
                  " vertex 0: a coordinate that is not finite; write a finite one");
    }
    EXPECT_EQ(
        error("ply\nformat binary_little_endian 1.0\nelement face 1\nelement vertex 1\nproperty "
              "float x\nproperty float y\nproperty float z\nend_header\n",
              as(SitesInput::ply))
            .substr(0, 61),
        "8:1: in binary files the vertices are to come first, and face");
}

TEST(OffSites, AreVertices) {
    EXPECT_EQ(read("OFF\n2 1 0 # of a part\n\n0 0 1\n1 2 3 255 0 0\n3 0 1 1\n", as(SitesInput::off))
                  .in_space,
              (Sites{{0, 0, 1, 0}, {1, 2, 3, 0}}));
    EXPECT_EQ(read("OFF 1 0 0\n1 2 3\n", as(SitesInput::off)).in_space, (Sites{{1, 2, 3, 0}}));
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::off));
    };
    const std::string advice =
        "; an OFF file is OFF, the numbers of vertices, faces and edges, and a line x y z for each "
        "vertex";
    EXPECT_EQ(wrong("4OFF\n"), "1:1: this is no OFF file" + advice);
    EXPECT_EQ(wrong("OFF\ntwo\n"), "2:1: the number of vertices is to stand here");
    EXPECT_EQ(wrong("OFF\n2 0 0\n1 2 3\n"), "3:1: the file ends after 1 of 2 vertices" + advice);
    EXPECT_EQ(wrong("OFF\n1 0 0\n1 2\n"), "3:4: a vertex is a line x y z");
    EXPECT_EQ(wrong("OFF\n1 0 0\n1 2 z\n"), "3:5: 'z'" + word);
    EXPECT_EQ(wrong("OFF\n0 0 0\n"), "2:1: no vertex in this file" + advice);
}

TEST(GroSites, AreInNanometres) {
    const std::string frame =
        "Two waters\n2\n    1SOL     OW    1   0.500   1.500   1.600\n    1SOL    HW1    2   0.525 "
        "  "
        "1.400  -1.612\n   2.0 2.0 2.0\n";
    const SitesFile file = read(frame, as(SitesInput::gro));
    EXPECT_EQ(file.in_space, (Sites{{0.5, 1.5, 1.6, 1.52 * 0.1}, {0.525, 1.4, -1.612, 1.2 * 0.1}}));
    expect_note(file,
                "f: 2 atoms name no element, and are taken by name and residue for one: 1 H, 1 O; "
                "lengths, radii among them, are nanometres; the periodic box is left out, and the "
                "atoms are in all of space");
    // Of two frames, the last with more digits, which are all read.
    const std::string precise =
        "t= 1\n1\n    1NA      NA    1   0.50001   1.50002   1.60003  0.1  0.2  0.3\n 2 2 2\n";
    EXPECT_EQ(read(frame + precise, as(SitesInput::gro)).in_space,
              (Sites{{0.50001, 1.50002, 1.60003, 2.27 * 0.1}}));
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::gro));
    };
    EXPECT_EQ(wrong("t\n1\n    1NA      NA    1   0.500   1.5x0   1.600\n"),
              "3:32: '1.5x0'" + word);
    EXPECT_EQ(wrong("t\nO 1\n"), "2:1: the number of atoms stands alone in the second line");
    EXPECT_EQ(wrong("t\n1\n    1NA      NA    1\n").substr(0, 20), "3:21: an atom withou");
}

TEST(LammpsSites, ArePlacedInTheirBox) {
    const auto dump = [](std::string_view bounds, std::string_view columns,
                         std::string_view atoms) {
        return fmt::format(
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS {}ITEM: ATOMS "
            "{}\n{}",
            bounds, columns, atoms);
    };
    const std::string box = "pp pp pp\n-1 3\n0 2\n10 20\n";
    const auto sites = [](const std::string& text) {
        return read(text, as(SitesInput::lammpstrj)).in_space;
    };
    EXPECT_EQ(sites(dump(box, "id type x y z radius", "2 1 1 2 3 0.5\n1 1 4 5 6 0.25\n")),
              (Sites{{1, 2, 3, 0.5}, {4, 5, 6, 0.25}}));
    EXPECT_EQ(sites(dump(box, "zu xu yu element", "3 1 2 O\n6 4 5 H\n")),
              (Sites{{1, 2, 3, 1.52}, {4, 5, 6, 1.2}}));
    EXPECT_EQ(sites(dump(box, "id xs ys zs", "1 0.5 0.25 0.5\n2 0 1 1\n")),
              (Sites{{1, 0.5, 15, 0}, {-1, 2, 20, 0}}));
    // A cell of vectors (4 0 0), (1 2 0) and (-0.5 0.25 10) from (-1, 0, 10).
    const std::string tilted = "xy xz yz pp pp pp\n-1.5 4 1\n0 2.25 -0.5\n10 20 0.25\n";
    EXPECT_EQ(sites(dump(tilted, "id xs ys zs", "1 0.5 0.5 0.5\n2 1 1 1\n")),
              (Sites{{1.25, 1.125, 15, 0}, {3.5, 2.25, 20, 0}}));
    const std::string first = dump(box, "id x y z", "1 9 9 9\n2 8 8 8\n");
    const SitesFile frames =
        read(first + dump(box, "id x y z", "1 1 2 3\n2 4 5 6\n"), as(SitesInput::lammpstrj));
    EXPECT_EQ(frames.in_space, (Sites{{1, 2, 3, 0}, {4, 5, 6, 0}}));
    expect_note(
        frames,
        "f: of 2 frames the last one is read; no atom has a radius, and all radii are 0; the "
        "box is left out, and the atoms are in all of space");
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::lammpstrj));
    };
    EXPECT_EQ(wrong("1 2 3\n"), "1:1: a line ITEM: ... is to stand here");
    EXPECT_EQ(wrong(dump(box, "id vx vy vz", "1 1 2 3\n2 4 5 6\n")),
              "9:13: the atoms have no columns x y z, xu yu zu, xs ys zs or xsu ysu zsu");
    EXPECT_EQ(wrong(dump(box, "id x y z", "1 1 2\n2 4 5 6\n")),
              "10:6: 3 columns, but ITEM: ATOMS names 4");
    EXPECT_EQ(wrong(dump(box, "id x y z", "1 1 2 3\n")).substr(0, 42),
              "10:1: the file ends after 1 of 2 atoms; a ");
    EXPECT_EQ(wrong(dump(box, "id x y z", "1 1 2 3\n1 1 2 nan\n")),
              "11:7: 'nan' is not a finite number; write a finite one");
}

TEST(CifSites, AreAtoms) {
    const std::string head =
        "data_1ABC\n#\nloop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_comp_id\n_atom_site.label_alt_id\n_atom_site.auth_asym_id\n"
        "_atom_site.auth_seq_id\n_atom_site.Cartn_z\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.pdbx_PDB_model_num\n";
    const SitesFile file = read(head +
                                    "1 N N SER . A 1 3.1 1.1 2.1(5) 1\n2 C CB SER B A 1 3 1 2 1\n"
                                    "3 C CB THR A A 1 4 1 2 1\n4 ? 'OG' SER B A 1 5 1 2 1\n"
                                    "5 N N SER . A 1 3 1 2 2\n",
                                as(SitesInput::cif));
    EXPECT_EQ(file.in_space, (Sites{{1.1, 2.1, 3.1, 1.55}, {1, 2, 3, 1.7}, {1, 2, 5, 1.52}}));
    EXPECT_EQ(file.third, WeightIs::radius);
    expect_note(file,
                "f: 1 alternate place of atoms left out; 1 atom of models after the first one left "
                "out; 1 atom names no element, and is taken by name and residue for one: 1 O");
    const auto wrong = [](std::string_view contents) {
        return error(contents, as(SitesInput::cif));
    };
    EXPECT_EQ(wrong(head + "7 N N SER . A 1 3.1 ? 2.1 1\n"), " atom 7: Cartn_x: no number");
    EXPECT_EQ(wrong(head + "7 N N SER . A 1 3.1 1.x 2.1 1\n"), " atom 7: Cartn_x: '1.x'" + word);
    EXPECT_EQ(
        wrong(head + "7 Pu N SER . A 1 3.1 1 2.1 1\n"),
        " atom 7: no van der Waals radius is known of 'Pu'; give one, as in --radius Pu=2.1, or "
        "radii of all atoms in a PQR file");
    EXPECT_TRUE(wrong("data_x\nloop_\n_a\n_b\n1 2 3\n").ends_with("; this is no CIF"));
    EXPECT_EQ(wrong("data_x\n_a 1\n"),
              " no atom in this file: no loop with _atom_site.Cartn_x, as mmCIF has it");
    EXPECT_NE(wrong("data_x\nloop_\n_atom_site_fract_x\n0.5\n").find("fractions"),
              std::string::npos);
}

TEST(GeoJsonSites, ArePoints) {
    const std::string features =
        "{\"type\": \"FeatureCollection\", \"features\": [\n"
        "{\"type\": \"Feature\", \"properties\": {\"name\": \"a\", \"r\": 2, \"n\": 7}, "
        "\"geometry\": {\"type\": \"Point\", \"coordinates\": [1.5, 2]}},\n"
        "{\"geometry\": {\"coordinates\": [[3, 4, 9], [5, 6, 8]], \"type\": \"MultiPoint\"}, "
        "\"properties\": {\"more\": {\"r\": [1, {}]}, \"n\": null, \"name\": \"b\"}, \"type\": "
        "\"Feature\"},\n"
        "{\"type\": \"Feature\", \"properties\": null, \"geometry\": null}]}";
    const SitesFile file = read(features, {.attributes = true});
    EXPECT_EQ(file.sites, (std::vector<Site>{{1.5, 2, 2}, {3, 4, 0}, {5, 6, 0}}));
    EXPECT_TRUE(file.are_degrees);
    EXPECT_EQ(file.attributes, (std::vector<Attribute>{{"name", {"a", "b", "b"}, false},
                                                       {"n", {"7", "", ""}, true}}));
    expect_note(
        file,
        "f: longitude is x and latitude is y, degrees that are taken for a plane's; heights "
        "are left out (2 of 3 points); --dimension 3 takes them for z; 1 feature that has no "
        "point is left out");
    EXPECT_EQ(read("{\"type\": \"Point\", \"coordinates\": [1, 2, 3]}", in_space).in_space,
              (Sites{{1, 2, 3, 0}}));
    const SitesFile projected = read(
        "{\"crs\": {\"type\": \"name\"}, \"type\": \"GeometryCollection\", \"geometries\": "
        "[{\"type\": \"Point\", \"bbox\": [1], \"coordinates\": [1e5, 2e5]}]}");
    EXPECT_EQ(projected.sites, (std::vector<Site>{{1e5, 2e5, 0}}));
    EXPECT_FALSE(projected.are_degrees);
    const std::string advice =
        "; of GeoJSON points are read, such as {\"type\": \"Point\", \"coordinates\": [x, y]}, "
        "alone, in features or in a collection";
    EXPECT_EQ(error("{\"type\": \"LineString\",\n \"coordinates\": [[1, 2], [3, 4]]}"),
              "1:1: a LineString is no point" + advice);
    EXPECT_EQ(error("{\"type\": \"Point\",\n \"coordinates\": [1]}"),
              "2:17: a point of less than 2 coordinates" + advice);
    EXPECT_EQ(error("{\"type\": \"Point\",\n \"coordinates\": [1, \"2\"]}"),
              "2:21: coordinates are numbers" + advice);
    EXPECT_EQ(error("{\"type\": \"Point\", \"coordinates\": [[1, 2]]}"),
              "1:1: coordinates of another shape than those of points" + advice);
    EXPECT_EQ(error("{\"type\": \"Point\", \"coordinates\": [1, 1e999]}").substr(0, 5), "1:38:");
    EXPECT_EQ(error("{\"type\": \"FeatureCollection\", \"features\": []}"),
              "1:1: no point in this file" + advice);
}

TEST(SitesFiles, MayBeCompressedByGzip) {
    // printf 'x y r\n1 2 3\n' | gzip -n, and the same of '4 5 6\n'.
    using namespace std::string_literals;
    const auto gzip = [](const std::string& text) {
        std::string packed(text.size() + 100, '\0');
        z_stream stream = {};
        constexpr int gzip_alone = 16 + MAX_WBITS;
        EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, gzip_alone, 8, Z_DEFAULT_STRATEGY), Z_OK);
        std::string copy = text;
        stream.next_in = reinterpret_cast<Bytef*>(copy.data());
        stream.avail_in = static_cast<uInt>(copy.size());
        stream.next_out = reinterpret_cast<Bytef*>(packed.data());
        stream.avail_out = static_cast<uInt>(packed.size());
        EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
        packed.resize(packed.size() - stream.avail_out);
        deflateEnd(&stream);
        return packed;
    };
    const std::string first = gzip("x y r\n1 2 3\n");
    EXPECT_EQ(read(first + gzip("4 5 6\n")).sites, (std::vector<Site>{{1, 2, 3}, {4, 5, 6}}));
    std::string lines;
    for (int i = 0; i < 300'000; ++i) lines += fmt::format("{} {}\n", i, i % 1000);
    EXPECT_EQ(read(gzip(lines)).sites.size(), 300'000U);
    EXPECT_EQ(error(gzip(lines + "1 two\n")), "300001:3: 'two'" + word);
    EXPECT_EQ(error(first.substr(0, first.size() - 9)),
              " this is compressed by gzip, and ends before its end");
    EXPECT_EQ(error(first + "xy").substr(0, 40), " this is compressed by gzip, and damaged");
    std::string damaged = first;
    damaged[damaged.size() - 6] ^= 1;
    EXPECT_EQ(error(damaged).substr(0, 40), " this is compressed by gzip, and damaged");
    EXPECT_EQ(error(gzip("1 2\n\0"s)).substr(0, 4), "2:1:");
}

TEST(SitesInput, IsToldByTheEnding) {
    EXPECT_EQ(input_by_ending("xyz"), SitesInput::xyz);
    EXPECT_EQ(input_by_ending("ent"), SitesInput::pdb);
    EXPECT_EQ(input_by_ending("node"), SitesInput::node);
    EXPECT_EQ(input_by_ending("csv"), SitesInput::text);
}

TEST(Elements, HaveRadii) {
    EXPECT_EQ(van_der_waals_radius("C"), 1.70);
    EXPECT_EQ(van_der_waals_radius("zn"), 1.39);
    EXPECT_EQ(van_der_waals_radius("Ca"), 2.31);
    EXPECT_EQ(van_der_waals_radius("FE"), 2.44);
    EXPECT_EQ(van_der_waals_radius(""), std::nullopt);
    EXPECT_EQ(van_der_waals_radius("Xx"), std::nullopt);
}

TEST(WriteSitesInSpace, ReadsBackToTheSameDoubles) {
    const Sites sites = {{0.1, -1e300, 5e-324, 1}, {1.0 / 3.0, 1e16, 0x1.fffffffffffffp1023, -0.0}};
    for (const SitesFormat format : {SitesFormat::text, SitesFormat::csv, SitesFormat::json}) {
        std::ostringstream out;
        write_sites(out, sites, format);
        EXPECT_EQ(read(out.str(), in_space).in_space, sites) << out.str();
        if (format != SitesFormat::text) {
            EXPECT_EQ(read(out.str()).in_space, sites) << out.str();
        }
    }
}

/// Balls of every kind: tied, hidden, apart.
Sites balls() {
    Sites sites =
        generate(SpaceDistribution::grid, {.count = 60, .radius_from = 1, .radius_to = 400});
    for (const Site3& each : generate(SpaceDistribution::sphere, {.count = 40}))
        sites.push_back(each);
    return sites;
}

std::size_t facets_of_hull(const SpaceTessellation& tessellation) {
    return static_cast<std::size_t>(std::ranges::count_if(
        tessellation.cells, [](const SpaceCell& cell) { return cell[0] == infinite; }));
}

/// Lines of a text by their first word.
std::map<std::string, std::vector<std::vector<double>>> lines_of(const std::string& text) {
    std::map<std::string, std::vector<std::vector<double>>> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first;
        std::vector<double> numbers;
        for (double number = 0; words >> number;) numbers.push_back(number);
        result[first].push_back(numbers);
    }
    return result;
}

TEST(WriteJsonInSpace, HoldsTheArrays) {
    const Sites sites = balls();
    const SpaceTessellation tessellation = triangulate(sites);
    ASSERT_FALSE(tessellation.hidden.empty());
    std::ostringstream out;
    write_json(out, tessellation, Metric::power, WeightIs::radius);
    const auto json = nlohmann::json::parse(out.str());
    EXPECT_EQ(json["format"], "signum.tessellation");
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["dimension"], 3);
    EXPECT_EQ(json["metric"], "power");
    EXPECT_EQ(json["weight_is"], "radius");
    EXPECT_EQ(json["sites"], 100);
    EXPECT_EQ(json["cells"].get<std::vector<SpaceCell>>(), tessellation.cells);
    EXPECT_EQ(json["neighbours"].get<std::vector<SpaceCell>>(), tessellation.neighbours);
    std::vector<std::array<Index, 2>> hidden;
    for (const auto& [site, by] : tessellation.hidden) hidden.push_back({site, by});
    EXPECT_EQ((json["hidden"].get<std::vector<std::array<Index, 2>>>()), hidden);
    EXPECT_FALSE(json.contains("statistics"));
    std::ostringstream counted;
    write_json(counted, tessellation, Metric::power, WeightIs::weight, Statistics{.seconds = 0.5});
    const auto other = nlohmann::json::parse(counted.str());
    EXPECT_EQ(other["weight_is"], "weight");
    EXPECT_EQ(other["statistics"]["seconds"], 0.5);
    EXPECT_TRUE(other["statistics"]["ccw"].is_null());
    EXPECT_FALSE(json.contains("vertices"));
    const std::vector<SpaceVertex> diagram = vertices(tessellation, std::span<const Site3>(sites));
    std::ostringstream with_vertices;
    write_json(with_vertices, tessellation, Metric::power, WeightIs::radius, {}, diagram);
    const auto all = nlohmann::json::parse(with_vertices.str())["vertices"];
    ASSERT_EQ(all.size(), tessellation.cells.size());
    for (std::size_t c = 0; c < all.size(); ++c) {
        if (tessellation.cells[c][0] == infinite) {
            EXPECT_TRUE(all[c].is_null());
        } else {
            const auto& [x, y, z, rho] = diagram[c];
            EXPECT_EQ((all[c].get<std::array<double, 4>>()), (std::array{x, y, z, rho}));
        }
    }
}

TEST(WriteJsonInSpace, WritesFlatSites) {
    const auto json = [](const Sites& sites) {
        std::ostringstream out;
        write_json(out, triangulate(sites), Metric::power, WeightIs::radius);
        return out.str().substr(out.str().find("\"dimension\""));
    };
    EXPECT_EQ(json({{0, 0, 5, 0}, {1, 0, 5, 0}, {0, 1, 5, 0}}),
              "\"dimension\": 2, \"metric\": \"power\", \"weight_is\": \"radius\", \"sites\": 3,\n"
              "\"cells\": [\n[-1, 0, 1],\n[-1, 0, 2],\n[-1, 1, 2],\n[0, 1, 2]],\n"
              "\"neighbours\": [\n[3, 2, 1],\n[3, 2, 0],\n[3, 1, 0],\n[2, 1, 0]],\n"
              "\"hidden\": []}\n");
    EXPECT_EQ(json({{0, 0, 5, 0}, {1, 1, 6, 0}}),
              "\"dimension\": 1, \"metric\": \"power\", \"weight_is\": \"radius\", \"sites\": 2,\n"
              "\"cells\": [\n[-1, 0],\n[-1, 1],\n[0, 1]],\n"
              "\"neighbours\": [\n[2, 1],\n[2, 0],\n[1, 0]],\n"
              "\"hidden\": []}\n");
    EXPECT_EQ(json({{0, 0, 5, 0}, {0, 0, 5, 1}}),
              "\"dimension\": 0, \"metric\": \"power\", \"weight_is\": \"radius\", \"sites\": 2,\n"
              "\"cells\": [\n[-1],\n[1]],\n\"neighbours\": [\n[1],\n[0]],\n"
              "\"hidden\": [\n[0, 1]]}\n");
}

TEST(WriteCsvInSpace, WritesTheCells) {
    const auto csv = [](const Sites& sites) {
        std::ostringstream out;
        write_csv(out, triangulate(sites));
        return out.str();
    };
    EXPECT_EQ(csv({{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}),
              "a,b,c,d\n-1,0,1,2\n-1,0,2,3\n-1,0,3,1\n-1,1,3,2\n0,1,2,3\n");
    EXPECT_EQ(csv({{0, 0, 0, 0}, {1, 0, 0, 0}}), "a,b\n-1,0\n-1,1\n0,1\n");
    EXPECT_EQ(csv({{0, 0, 0, 0}}), "a\n-1\n0\n");
}

TEST(WriteObjInSpace, WritesEveryFiniteFacetOnce) {
    const Sites sites = balls();
    const SpaceTessellation tessellation = triangulate(sites);
    std::ostringstream out;
    write_obj(out, tessellation, sites);
    const auto lines = lines_of(out.str());
    EXPECT_EQ(lines.at("v").size(), sites.size());
    EXPECT_EQ(lines.at("v")[7], (std::vector<double>{sites[7].x, sites[7].y, sites[7].z}));
    // Each finite cell has four facets, of which those inside are shared by two.
    const std::size_t hull = facets_of_hull(tessellation);
    const std::size_t finite = tessellation.cells.size() - hull;
    std::vector<std::vector<double>> facets = lines.at("f");
    EXPECT_EQ(facets.size(), (4 * finite + hull) / 2);
    // The hull comes first and turns outward: its volume is that of the cells.
    const auto volume = [&](std::size_t a, std::size_t b, std::size_t c, const Site3& from) {
        const Site3& p = sites[a];
        const Site3& q = sites[b];
        const Site3& r = sites[c];
        const double ux = p.x - from.x, uy = p.y - from.y, uz = p.z - from.z;
        const double vx = q.x - from.x, vy = q.y - from.y, vz = q.z - from.z;
        const double wx = r.x - from.x, wy = r.y - from.y, wz = r.z - from.z;
        return ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
    };
    double inside = 0;
    for (std::size_t i = 0; i < hull; ++i) {
        const auto at = [&](std::size_t k) { return static_cast<std::size_t>(facets[i][k]) - 1; };
        inside += volume(at(0), at(1), at(2), {});
    }
    double of_cells = 0;
    for (const auto& [a, b, c, d] : tessellation.cells) {
        if (a == infinite) continue;
        const auto at = [](Index site) { return static_cast<std::size_t>(site); };
        const double each = volume(at(b), at(c), at(d), sites[at(a)]);
        EXPECT_GT(each, 0);
        of_cells += each;
    }
    EXPECT_NEAR(inside / of_cells, 1, 1e-9);
    for (std::vector<double>& facet : facets) std::ranges::sort(facet);
    std::ranges::sort(facets);
    EXPECT_EQ(std::ranges::adjacent_find(facets), facets.end());
}

TEST(WriteObjInSpace, WritesFlatSites) {
    const auto obj = [](const Sites& sites) {
        std::ostringstream out;
        write_obj(out, triangulate(sites), sites);
        return out.str();
    };
    const std::string head = "# signum: power tessellation of space, a vertex a site\n";
    EXPECT_EQ(obj({{0, 0, 5, 0}, {1, 0, 5, 0}, {0, 1, 5, 0}}),
              head + "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 1 2 3\n");
    EXPECT_EQ(obj({{0, 0, 5, 0}, {1, 0, 5, 0}}), head + "v 0 0 5\nv 1 0 5\nl 1 2\n");
    EXPECT_EQ(obj({{0, 0, 5, 0}}), head + "v 0 0 5\np 1\n");
}

TEST(WriteVtk, WritesFiniteCells) {
    const Sites sites = balls();
    const SpaceTessellation tessellation = triangulate(sites);
    const std::size_t finite = tessellation.cells.size() - facets_of_hull(tessellation);
    std::ostringstream out;
    write_vtk(out, vtk_grid(tessellation, sites, WeightIs::radius));
    std::istringstream in(out.str());
    std::string line;
    for (const char* head : {"# vtk DataFile Version 3.0", "signum: power tessellation of space",
                             "ASCII", "DATASET UNSTRUCTURED_GRID", "POINTS 100 double"}) {
        std::getline(in, line);
        EXPECT_EQ(line, head);
    }
    for (const Site3& site : sites) {
        Site3 read;
        in >> read.x >> read.y >> read.z;
        EXPECT_EQ(read, (Site3{site.x, site.y, site.z, 0}));
    }
    std::size_t cells = 0;
    std::size_t numbers = 0;
    in >> line >> cells >> numbers;
    EXPECT_EQ(line, "CELLS");
    EXPECT_EQ(cells, finite);
    EXPECT_EQ(numbers, 5 * finite);
    std::vector<SpaceCell> read(cells);
    for (SpaceCell& cell : read) {
        int size = 0;
        in >> size;
        EXPECT_EQ(size, 4);
        for (Index& vertex : cell) in >> vertex;
    }
    std::vector<SpaceCell> expected = tessellation.cells;
    std::erase_if(expected, [](const SpaceCell& cell) { return cell[0] == infinite; });
    EXPECT_EQ(read, expected);
    in >> line >> cells;
    EXPECT_EQ(line, "CELL_TYPES");
    EXPECT_EQ(cells, finite);
    for (std::size_t i = 0; i < finite; ++i) {
        int kind = 0;
        in >> kind;
        EXPECT_EQ(kind, 10);
    }
    std::string rest;
    while (in >> line) rest += line + " ";
    EXPECT_TRUE(rest.starts_with("POINT_DATA 100 SCALARS radius double 1 LOOKUP_TABLE default "))
        << rest.substr(0, 100);
    const std::size_t hidden = rest.find("SCALARS hidden int 1 LOOKUP_TABLE default ");
    ASSERT_NE(hidden, std::string::npos);
    EXPECT_EQ(static_cast<std::size_t>(std::count(
                  rest.begin() + static_cast<std::ptrdiff_t>(hidden + 22), rest.end(), '1')),
              tessellation.hidden.size());
}

TEST(WriteVtk, WritesFlatSites) {
    const auto vtk = [](const Sites& sites) {
        std::ostringstream out;
        write_vtk(out, vtk_grid(triangulate(sites), sites, WeightIs::weight));
        return out.str();
    };
    EXPECT_NE(vtk({{0, 0, 5, 0}, {1, 0, 5, 0}, {0, 1, 5, 0}})
                  .find("CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nPOINT_DATA 3\nSCALARS weight double"),
              std::string::npos);
    EXPECT_NE(vtk({{0, 0, 5, 0}, {1, 0, 5, 0}}).find("CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n"),
              std::string::npos);
    EXPECT_NE(vtk({{0, 0, 5, 0}}).find("CELLS 1 2\n1 0\nCELL_TYPES 1\n1\n"), std::string::npos);
}

TEST(ReadTessellation, SaysThatItIsInSpace) {
    std::ostringstream out;
    write_json(out, triangulate(balls()), Metric::power, WeightIs::radius);
    const test::Scratch scratch;
    EXPECT_TRUE(read_tessellation(scratch.file("t.json", out.str())).in_space);
}

}  // namespace
}  // namespace signum
