#include "pictures.hpp"

#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/output_file.hpp"

namespace signum {
namespace {

void require_ffmpeg() {
    if (has_program("ffmpeg", "-version")) return;
    throw MachineError(
        "a video is made by ffmpeg, which is not there; install it (Debian: apt-get install "
        "ffmpeg), or leave video out of [record]");
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
    if (!video_.empty()) require_ffmpeg();
}

std::string Pictures::made(std::size_t number) const {
    return folder_.file(fmt::format("{:07}.png", number));
}

void Pictures::add(std::string_view svg) {
    OutputFile image(made(count_));
    image.stream() << converter_.convert(svg, Converted::png);
    image.publish();
    ++count_;
}

void Pictures::publish() {
    const std::string video = folder_.file("video.mp4");
    if (!video_.empty() &&
        run_program("ffmpeg", {"-y", "-loglevel", "error", "-nostdin", "-framerate", "25", "-i",
                               folder_.file("%07d.png"), "-pix_fmt", "yuv420p", video})
                .status != 0)
        throw MachineError("ffmpeg failed at the video");
    if (!images_.empty())
        for (std::size_t i = 0; i < count_; ++i) copy_to(made(i), numbered(images_, i));
    if (!video_.empty()) copy_to(video, video_);
}

}  // namespace signum
