#include "write_ply.hpp"

#include <algorithm>

#include "text_writer.hpp"

namespace signum {
namespace {

void put_head(TextWriter& text, std::string_view what, std::size_t vertices, WeightIs weight_is) {
    text.put(FMT_COMPILE("ply\nformat ascii 1.0\ncomment signum: {}\nelement vertex {}\n"
                         "property double x\nproperty double y\nproperty double z\n"
                         "property double {}\n"),
             what, vertices, name_of(weight_is));
}

}  // namespace

void write_ply(std::ostream& out, const Tessellation& tessellation) {
    const auto is_finite = [](const Face& face) { return face[0] != infinite; };
    const auto sites = tessellation.sites();
    const auto faces = tessellation.faces();
    TextWriter text(out);
    put_head(text, fmt::format("{} tessellation", name_of(tessellation.metric())), sites.size(),
             tessellation.weight_is());
    text.put(FMT_COMPILE("element face {}\nproperty list uchar int vertex_indices\nend_header\n"),
             std::ranges::count_if(faces, is_finite));
    for (const auto& [x, y, r] : sites) text.put(FMT_COMPILE("{} {} 0 {}\n"), x, y, r);
    for (const Face& face : faces)
        if (is_finite(face)) text.put(FMT_COMPILE("3 {}\n"), fmt::join(face, " "));
    text.flush();
}

void write_ply(std::ostream& out, std::span<const Site3> sites, WeightIs weight_is) {
    TextWriter text(out);
    put_head(text, "sites in space", sites.size(), weight_is);
    text.put("end_header\n");
    for (const auto& [x, y, z, r] : sites) text.put(FMT_COMPILE("{} {} {} {}\n"), x, y, z, r);
    text.flush();
}

}  // namespace signum
