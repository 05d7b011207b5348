#pragma once
/// The folder beside an output in which signum triangulate --resume keeps pieces, and the manifest
/// that says what they belong to.
///
/// Laws:
///  1. One process at a time uses a folder: it holds a lock on the manifest.
///  2. remove() takes away what signum has put there, and nothing else.

#include <string>

#include <nlohmann/json.hpp>

namespace signum::cli {

class PartsFolder {
 public:
    /// Makes the folder where it is not there. Throws MachineError where that fails, or where
    /// another process uses the folder; CallError where the manifest is none.
    explicit PartsFolder(std::string path);
    PartsFolder(const PartsFolder&) = delete;
    PartsFolder& operator=(const PartsFolder&) = delete;
    /// The folder stays where it has a manifest.
    ~PartsFolder();

    [[nodiscard]] const std::string& path() const noexcept { return path_; }

    /// What the pieces have to belong to. Throws CallError where the manifest has another value
    /// for one of these keys.
    void require(const nlohmann::json& values);
    /// What the manifest says beside that, for a message.
    void note(const nlohmann::json& values) { asked_.update(values); }
    /// Writes all that was required or noted into the manifest where that is empty.
    void write();
    /// With all pieces.
    void remove() noexcept;

 private:
    [[nodiscard]] std::string manifest() const { return path_ + "/manifest.json"; }
    /// Those that are unfinished, and pieces, too.
    void remove_files(bool pieces) const noexcept;

    std::string path_;
    int descriptor_ = -1;   ///< of the manifest; -1 once the folder is removed
    nlohmann::json there_;  ///< what the manifest says; null where it is empty
    nlohmann::json asked_;
};

}  // namespace signum::cli
