#pragma once
/// Frames as images (io/svg_converter.hpp) and as a video, made by ffmpeg.
///
/// Law: nothing appears under its name before all is made.

#include <cstddef>
#include <string>
#include <string_view>

#include "../io/program.hpp"
#include "../io/svg_converter.hpp"

namespace signum {

class Pictures {
 public:
    /// `images` has one %d, as in "image-%04d.png", for the number of a frame from 0 on; either may
    /// be empty. Throws MachineError where a program that is needed is not there, and says what to
    /// install.
    Pictures(std::string images, std::string video);

    /// A frame, as SVG, all of one size with even sides. Throws MachineError. Some 20 ms.
    void add(std::string_view svg);
    /// The images under their names, the video from 25 of them a second. Throws MachineError.
    void publish();

 private:
    [[nodiscard]] std::string made(std::size_t number) const;

    SvgConverter converter_;
    std::string images_;
    std::string video_;
    ScratchFolder folder_ = ScratchFolder("pictures");  ///< where images are until all are there
    std::size_t count_ = 0;
};

}  // namespace signum
