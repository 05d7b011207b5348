#include "pictures.hpp"

#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/output_file.hpp"
#include "../io/program.hpp"

namespace signum {
namespace {

void require_program(const std::string& name, const std::string& argument, std::string_view what,
                     std::string_view package) {
    if (has_program(name, argument)) return;
    throw MachineError(fmt::format(
        "{} by {}, which is not there; install it (Debian: apt-get install {}), or leave {} out of "
        "[record]",
        what == "images" ? "images are drawn" : "a video is made", name, package, what));
}

void run_well(const std::string& name, std::vector<std::string> arguments, std::string_view what) {
    if (run_program(name, std::move(arguments)).status != 0)
        throw MachineError(fmt::format("{} failed at {}", name, what));
}

/// "image-%04d.png" with a number.
std::string numbered(const std::string& pattern, std::size_t number) {
    const std::size_t sign = pattern.find('%');
    const std::size_t letter = pattern.find('d', sign);
    const std::string spec = pattern.substr(sign + 1, letter - sign);
    return pattern.substr(0, sign) + fmt::format(fmt::runtime("{:" + spec + "}"), number) +
           pattern.substr(letter + 1);
}

void copy_to(const std::string& from, const std::string& to) {
    OutputFile file(to);
    file.stream() << std::ifstream(from, std::ios::binary).rdbuf();
    file.publish();
}

}  // namespace

Pictures::Pictures(std::string images, std::string video)
    : images_(std::move(images)), video_(std::move(video)) {
    require_program("rsvg-convert", "--version", images_.empty() ? "video" : "images",
                    "librsvg2-bin");
    if (!video_.empty()) require_program("ffmpeg", "-version", "video", "ffmpeg");
}

std::string Pictures::made(std::size_t number) const {
    return folder_.file(fmt::format("{:07}.png", number));
}

void Pictures::add(std::string_view svg) {
    const std::string drawing = folder_.file("frame.svg");
    std::ofstream(drawing, std::ios::binary) << svg;
    run_well("rsvg-convert", {"-o", made(count_), drawing}, "an image");
    ++count_;
}

void Pictures::publish() {
    const std::string video = folder_.file("video.mp4");
    if (!video_.empty())
        run_well("ffmpeg",
                 {"-y", "-loglevel", "error", "-nostdin", "-framerate", "25", "-i",
                  folder_.file("%07d.png"), "-pix_fmt", "yuv420p", video},
                 "the video");
    if (!images_.empty())
        for (std::size_t i = 0; i < count_; ++i) copy_to(made(i), numbered(images_, i));
    if (!video_.empty()) copy_to(video, video_);
}

}  // namespace signum
