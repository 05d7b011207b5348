/// Sites of space from text, JSON, atoms and meshes; tessellations of space to JSON, CSV, OBJ and
/// VTK.

#include <algorithm>
#include <array>
#include <cstdint>
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
    const SitesFile file = read("x y z r\n1 2 3 4\n5 6 7\n");
    EXPECT_EQ(file.dimension, 3);
    EXPECT_EQ(file.in_space, (Sites{{1, 2, 3, 4}, {5, 6, 7, 0}}));
    EXPECT_TRUE(file.sites.empty());
    expect_note(file, "f:3: the line ends before its radius, which is 0 then (1 of 2 lines)");
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
    EXPECT_EQ(error("x y z r\n1 2\n"),
              "2:4: the line ends before the columns x, y and z; write all three");
    EXPECT_EQ(error("x y z r\n1 2 3 4 5\n"),
              "2:9: 5 columns, but the header names 4; write as many, or choose with --columns, as "
              "in --columns 1,2,3");
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
        "1:1: the header does not name x, y and z; name the columns x, y, z and r (or radius, "
        "weight), or choose with --columns, as in --columns 1,2,3");
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
                "f:1: 'zz' is left out: sites lie in space where it is called z. --columns 1,2,3,4 "
                "takes it for z, --columns 1,2,4 leaves it out without a word");
    EXPECT_EQ(read("x,y,zz,r\n1,2,3,4\n", {.columns = {"1", "2", "3", "4"}}).in_space,
              (Sites{{1, 2, 3, 4}}));
    const SitesFile alone = read("x_um,y_um,z_um\n1,2,3\n");
    EXPECT_EQ(alone.sites, (std::vector<Site>{{1, 2, 0}}));
    expect_note(alone,
                "f:1: 'x_um' is x, 'y_um' is y, and 'z_um' is left out: sites lie in space where "
                "it is called z. --dimension 3 --columns 1,2,3 takes it for z, --columns 1,2 "
                "leaves it out without a word");
    for (const char* name : {"pz", "pos.z", "Z [m]", "z1", "center_z"})
        EXPECT_NE(read(std::string("x,y,") + name + ",r\n1,2,3,4\n").note, "") << name;
    for (const char* name : {"zone", "size", "m", "", "fizz"})
        EXPECT_EQ(read(std::string("x,y,") + name + ",r\n1,2,3,4\n").note, "") << name;
    EXPECT_EQ(read("x,y,zz,r\n1,2,3,4\n", {.dimension = 2}).note, "");
    EXPECT_EQ(error("a,b,c,d\n1,2,3,4\n"),
              "1:1: a header of more than three columns, and none is called x or y; choose them "
              "with --columns, as in --columns 1,2, or --columns 1,2,3,4 for x, y, z and r in "
              "space");
    EXPECT_EQ(error("x,y,zz,m\n1,2,3,4\n"),
              "1:1: the header names x and y and several other columns, but no r; name one column "
              "r, radius or weight, or choose with --columns, as in --columns x,y; where one is "
              "called z, sites lie in space");
}

TEST(Sites, SayWhichFormatIsNotRead) {
    const std::string mmcif =
        "this is mmCIF, which is not read; give the atoms as PDB, PQR or XYZ, "
        "or their coordinates as lines x,y,z,r below this header";
    EXPECT_EQ(error("data_1ABC\n#\n_entry.id 1ABC\n"), "1:1: " + mmcif);
    EXPECT_EQ(error("# made by hand\ndata_1ABC\n", in_space), "2:1: " + mmcif);
    for (const auto& [mark, name] : std::map<std::string, std::string>{{"\x1F\x8B\x08", "gzip"},
                                                                       {"\xFD\x37zXZ", "xz"},
                                                                       {"\x28\xB5\x2F\xFD", "zstd"},
                                                                       {"PK\x03\x04", "zip"}}) {
        for (const SitesInput input : {SitesInput::text, SitesInput::pdb, SitesInput::ply})
            EXPECT_EQ(error(mark + std::string(3, '\0'), as(input)),
                      " this is compressed by " + name +
                          ", and compressed files are not read; decompress it first");
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
    EXPECT_EQ(file.in_space, (Sites{{0, 0, 0, 1.52}, {0.96, 0, 0, 1.2}, {-0.24, 0.93, 0, 0}}));
    expect_note(file, "f: 1 of 3 atoms have no radius, and theirs are 0");
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
    expect_note(file,
                "f: 1 alternate place of atoms and 7 atoms of models after the first one are left "
                "out");
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
        "1:77: no van der Waals radius is known of 'X'; name an element in columns 77 and 78, or "
        "give radii in a PQR file");
}

TEST(PdbSites, TakeNoElementForAnother) {
    const auto of = [](std::string_view name, std::string_view element) {
        return fmt::format(
            "HETATM    1 {:4} OS  A   1       1.000   2.000   3.000  1.00  0.00{:>12}\n", name,
            element);
    };
    const auto refused = [](std::size_t column, std::string_view shown) {
        return fmt::format(
            "1:{}: no van der Waals radius is known of '{}'; name an element in "
            "columns 77 and 78, or give radii in a PQR file",
            column, shown);
    };
    // Osmium is no oxygen, iridium no iodine.
    EXPECT_EQ(error(of("OS", "OS"), as(SitesInput::pdb)), refused(77, "OS"));
    EXPECT_EQ(error(of(" O", "IR"), as(SitesInput::pdb)), refused(77, "IR"));
    EXPECT_EQ(error(of("OS", ""), as(SitesInput::pdb)), refused(13, "OS"));
    EXPECT_EQ(error(of("IR", ""), as(SitesInput::pdb)), refused(13, "IR"));
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
        "; a PLY file begins with ply, format ascii 1.0, and element vertex with properties x, y "
        "and z";
    EXPECT_EQ(wrong("1 2 3\n"), "1:1: this is no PLY file" + advice);
    EXPECT_EQ(wrong("ply\nformat binary_little_endian 1.0\n"),
              "2:8: a PLY file is read in ASCII alone; save it as format ascii 1.0");
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
