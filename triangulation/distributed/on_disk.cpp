#include "on_disk.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <system_error>

#include "../../core/insertion_rounds.hpp"
#include "../../core/parallel.hpp"
#include "../options.hpp"
#include "common.hpp"
#include "cuts.hpp"
#include "shared_exchange.hpp"
#include "site_store.hpp"
#include "whole.hpp"

namespace signum::distributed {
namespace {

/// Values in a file without a name, which is gone with the process, however that ends.
template <class T>
class Scratch {
 public:
    explicit Scratch(const std::string& folder) {
        descriptor_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
        if (descriptor_ >= 0) return;
        // Not every file system has such files.
        std::string name = folder + "/signum_XXXXXX";
        descriptor_ = ::mkstemp(name.data());
        if (descriptor_ < 0) fail("no file can be made in " + folder);
        ::unlink(name.c_str());
    }
    Scratch(Scratch&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)),
          size_(other.size_),
          waiting_(std::move(other.waiting_)) {}
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    Scratch& operator=(Scratch&&) = delete;
    ~Scratch() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_ + waiting_.size(); }
    void append(const T& value) {
        waiting_.push_back(value);
        constexpr std::size_t many = (std::size_t{1} << 16) / sizeof(T);
        if (waiting_.size() >= many) flush();
    }
    void append(std::span<const T> values) {
        flush();
        write(values);
    }
    [[nodiscard]] std::vector<T> read() {
        flush();
        std::vector<T> values(size_);
        auto* to = reinterpret_cast<char*>(values.data());
        for (std::size_t done = 0, all = size_ * sizeof(T); done < all;) {
            const ssize_t count =
                ::pread(descriptor_, to + done, all - done, static_cast<off_t>(done));
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) fail("a file of the work cannot be read");
            done += static_cast<std::size_t>(count);
        }
        return values;
    }
    [[nodiscard]] int descriptor() {
        flush();
        return descriptor_;
    }

 private:
    [[noreturn]] static void fail(const std::string& what) {
        throw std::system_error(errno, std::generic_category(), what);
    }
    void flush() {
        write(waiting_);
        waiting_.clear();
    }
    void write(std::span<const T> values) {
        const auto* from = reinterpret_cast<const char*>(values.data());
        for (std::size_t done = 0, all = values.size_bytes(); done < all;) {
            const ssize_t count = ::write(descriptor_, from + done, all - done);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) fail("the files of the work cannot be written");
            done += static_cast<std::size_t>(count);
        }
        size_ += values.size();
    }
    int descriptor_;
    std::size_t size_ = 0;
    std::vector<T> waiting_;
};

/// All values of a file, read as they are asked for.
template <class T>
class Mapped {
 public:
    explicit Mapped(Scratch<T>& file) : size_(file.size()) {
        if (size_ == 0) return;
        void* const at =
            ::mmap(nullptr, size_ * sizeof(T), PROT_READ, MAP_PRIVATE, file.descriptor(), 0);
        if (at == MAP_FAILED)
            throw std::system_error(errno, std::generic_category(), "the sites cannot be mapped");
        values_ = static_cast<const T*>(at);
    }
    Mapped(const Mapped&) = delete;
    Mapped& operator=(const Mapped&) = delete;
    ~Mapped() {
        if (values_ != nullptr) ::munmap(const_cast<T*>(values_), size_ * sizeof(T));
    }
    [[nodiscard]] std::span<const T> all() const noexcept { return {values_, size_}; }
    /// What has been read is no longer kept.
    void forget() const noexcept {
        if (values_ != nullptr)
            ::madvise(const_cast<T*>(values_), size_ * sizeof(T), MADV_DONTNEED);
    }

 private:
    std::size_t size_;
    const T* values_ = nullptr;
};

/// How far the work is.
class Steps {
 public:
    explicit Steps(const DiskOptions& options) : options_(options) {}
    /// How many there are. Before it is known nothing is told.
    void expect(std::size_t all) noexcept { all_ = all; }
    /// One more of as many as there are, on whatever thread. Throws Stopped.
    void step() {
        const std::size_t done = ++done_;
        if (options_.stop.stop_requested()) throw Stopped();
        const std::lock_guard lock(one_at_a_time_);
        if (options_.progress && all_ > 0 && done > told_) {
            told_ = done;
            options_.progress(static_cast<double>(done) / static_cast<double>(all_));
        }
    }

 private:
    const DiskOptions& options_;
    std::size_t all_ = 0;
    std::atomic<std::size_t> done_ = 0;
    std::mutex one_at_a_time_;
    std::size_t told_ = 0;
};

template <std::size_t corners>
void build_on_disk(const SlicedSites& sites, const Kind& kind, const DiskOptions& options,
                   const std::function<void(const WholeCounts&)>& begin,
                   const std::function<void(std::span<const std::int64_t>)>& put) {
    // More files for what is made than parts, for the first ones have more faces: of three sites
    // one is among the first half nearly always.
    const auto files_for = [](std::size_t parts) { return std::min(corners * parts, most_parts); };
    Steps steps(options);
    WholeCounts counts;

    // Once through the sites for a sample: all of the first ones, then ever fewer.
    constexpr std::size_t most_sampled = 65'536;
    std::vector<Placed> sample;
    std::uint64_t spared = ~std::uint64_t{0};
    for (std::size_t slice = 0; slice < sites.slices; ++slice) {
        const std::vector<Placed> some = sites.read(slice);
        check(some, kind);
        counts.sites += static_cast<std::int64_t>(some.size());
        const auto is_in = [&](const Placed& each) {
            return mix(static_cast<std::uint64_t>(each.id)) <= spared;
        };
        for (const Placed& each : some) {
            if (!is_in(each)) continue;
            sample.push_back(each);
            if (sample.size() < 2 * most_sampled) continue;
            spared /= 2;
            std::erase_if(sample, [&](const Placed& one) { return !is_in(one); });
        }
        steps.step();
    }
    if (counts.sites == 0) throw NoStructure("no site");
    const std::size_t parts = options.parts(counts.sites);
    if (parts == 0 || parts > most_parts)
        throw std::invalid_argument("parts: " + std::to_string(parts) + ", 1 to " +
                                    std::to_string(most_parts) + " are possible");
    counts.parts = parts;
    steps.expect(2 * sites.slices + 2 * parts + files_for(parts));
    std::vector<Point3> points;
    for (const Placed& each : sample) points.push_back(place_of(each));
    const Cuts cuts(std::move(points), parts);

    // And once more, for the parts.
    std::vector<std::size_t> begins(1, 0);
    Scratch<Placed> in_parts(options.folder);
    {
        std::vector<Scratch<Placed>> dealt;
        for (std::size_t k = 0; k < parts; ++k) dealt.emplace_back(options.folder);
        for (std::size_t slice = 0; slice < sites.slices; ++slice) {
            for (const Placed& each : sites.read(slice))
                dealt[cuts.part_of(place_of(each))].append(each);
            steps.step();
        }
        while (!dealt.empty()) {
            // The last one first, so that each is gone when it has been read.
            std::vector<Placed> own = dealt.back().read();
            dealt.pop_back();
            order_along_curve(own, kind);
            in_parts.append(own);
            begins.push_back(in_parts.size());
            steps.step();
        }
    }
    const Mapped<Placed> mapped(in_parts);
    std::vector<SiteStore> stores;
    Extent whole = no_extent();
    // The last part came first.
    for (std::size_t k = parts; k-- > 0;) {
        stores.emplace_back(mapped.all().subspan(begins[k], begins[k + 1] - begins[k]), kind);
        if (!is_empty(stores.back().extent())) whole.include(stores.back().extent());
        mapped.forget();
    }

    Farthest farthest(kind, whole);
    farthest.include(sample);
    std::vector<Placed> candidates;
    std::vector<Placed> greatest;
    const auto add = [](std::vector<Placed>& all, const std::vector<Placed>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const SiteStore& store : stores) {
        add(candidates, endless_among(store, farthest));
        add(greatest, greatest_of(store.sites(), kind));
        mapped.forget();
    }
    const std::vector<Placed> common = common_of(std::move(candidates), greatest, kind);
    std::vector<PartBounds> bounds;
    for (const SiteStore& store : stores) {
        bounds.push_back({store.extent_but(common), store.spacing()});
        mapped.forget();
    }

    // Faces go to files by their first sites.
    const std::size_t count = files_for(parts);
    const Stretches stretches(counts.sites, count);
    std::vector<Scratch<WholeCell<corners>>> files;
    for (std::size_t k = 0; k < count; ++k) files.emplace_back(options.folder);
    std::mutex one_at_a_time;
    const Workers workers(options.threads, static_cast<std::size_t>(counts.sites));
    workers.each(parts, [&](std::size_t number) {
        std::vector<Placed> others;
        std::ranges::copy_if(common, std::back_inserter(others), [&](const Placed& each) {
            return cuts.part_of(place_of(each)) != number;
        });
        SharedExchange exchange(stores);
        const std::unique_ptr<Part> part = make_part(kind);
        part->settle(stores[number], others, bounds, number, exchange, options.stop);
        const std::lock_guard lock(one_at_a_time);
        counts.hidden += static_cast<std::int64_t>(part->hidden().size());
        part->each_face([&](std::span<const std::int64_t> sites_of_cell) {
            WholeCell<corners> cell;
            std::ranges::copy(sites_of_cell, cell.begin());
            ++counts.faces;
            counts.infinite_faces += cell[0] < 0 ? 1 : 0;
            files[stretches.of(cell[0])].append(cell);
        });
        mapped.forget();
        steps.step();
    });

    begin(counts);
    for (std::size_t k = 0; k < count; ++k) {
        const SortedCells<corners> sorted(files[k].read(), stretches.begin_of_faces(k),
                                          stretches.begin(k + 1));
        put({sorted.cells().data()->data(), corners * sorted.cells().size()});
        steps.step();
    }
}

}  // namespace

void triangulate_on_disk(const SlicedSites& sites, const Kind& kind, const DiskOptions& options,
                         const std::function<void(const WholeCounts&)>& begin,
                         const std::function<void(std::span<const std::int64_t>)>& put) {
    if (kind.dimension == 3)
        build_on_disk<4>(sites, kind, options, begin, put);
    else
        build_on_disk<3>(sites, kind, options, begin, put);
}

}  // namespace signum::distributed
