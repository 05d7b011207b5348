#pragma once
/// Long work: the interpreter is free while it runs, and is looked after now and then, so that
/// Ctrl-C ends it and who asked is told how far it has come.

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

#include "../../exact/floating_environment.hpp"
#include "../../exact/kept_environment.hpp"
#include "../../triangulation/options.hpp"

namespace signum::python {

namespace py = pybind11;

/// Python before 3.14 ends a thread that asks for the interpreter while that is going down. Where
/// the system does so by unwinding the stack, frames that may not throw would end the process with
/// an error. So the thread sleeps here until the process ends.
[[noreturn]] inline void sleep_until_process_ends() noexcept {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

/// While it lives, other threads of Python may run.
class Released {
 public:
    Released() : state_(PyEval_SaveThread()) {}
    Released(const Released&) = delete;
    Released& operator=(const Released&) = delete;
    ~Released() {
        try {
            PyEval_RestoreThread(state_);
        } catch (...) {
            sleep_until_process_ends();
        }
    }

 private:
    PyThreadState* state_;
};

/// Of one piece of work. Made and destroyed by who holds the interpreter, asked by who does not.
class Watch {
 public:
    /// Throws TypeError where `progress` is there and cannot be called.
    explicit Watch(py::object progress) : progress_(std::move(progress)) {
        if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0)
            throw py::type_error("progress: a function is needed, or None");
    }

    [[nodiscard]] std::stop_token token() const noexcept { return source_.get_token(); }
    [[nodiscard]] bool stops() const noexcept { return source_.stop_requested(); }
    /// Looks after the interpreter, ten times a second at most.
    void look(double share) noexcept {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) return;
        try {
            const py::gil_scoped_acquire held;
            const exact::KeptEnvironment kept;
            try {
                ask(share);
            } catch (const py::error_already_set&) {
                error_ = std::current_exception();
                source_.request_stop();
            }
        } catch (...) {
            sleep_until_process_ends();  // with what unwinds the stack, and nothing else
        }
        last_ = std::chrono::steady_clock::now();
    }
    /// The same in a loop of one's own. Throws Stopped.
    void at(std::size_t done, std::size_t all) {
        if (done % 1024 != 0) return;
        look(static_cast<double>(done) / static_cast<double>(all));
        if (stops()) throw Stopped();
    }
    [[nodiscard]] std::function<void(double)> progress() {
        return [this](double share) { look(share); };
    }
    /// For who asks whether to stop.
    [[nodiscard]] std::function<bool()> stop() {
        return [this] {
            look(0.0);
            return stops();
        };
    }
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

 private:
    /// In C alone, which has nothing to destroy where the interpreter goes down meanwhile.
    void ask(double share) const {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (progress_.is_none()) return;
        PyObject* const told = PyObject_CallFunction(progress_.ptr(), "d", share);
        if (told == nullptr) throw py::error_already_set();
        Py_DECREF(told);
    }

    py::object progress_;
    std::stop_source source_;
    std::exception_ptr error_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What work(watch) gives, if anything, in the default floating-point environment. Throws what a
/// signal or the progress callback threw.
template <class Work>
auto watched(const py::object& progress, Work&& work) {
    Watch watch(progress);
    const auto released = [&] {
        const Released while_it_works;
        const exact::IeeeEnvironment environment;
        return std::forward<Work>(work)(watch);
    };
    try {
        if constexpr (std::is_void_v<decltype(released())>) {
            released();
            watch.rethrow();
        } else {
            auto result = released();
            watch.rethrow();
            return result;
        }
    } catch (const Stopped&) {
        watch.rethrow();
        throw;
    }
}
template <class Work>
auto watched(Work&& work) {
    return watched(py::none(), std::forward<Work>(work));
}

/// Something that changes: one call at a time. As the interpreter is free while a call runs,
/// another thread, or a callback, may come in between.
template <class Value>
class Exclusive {
 public:
    template <class... Arguments>
    explicit Exclusive(Arguments&&... arguments) : value_(std::forward<Arguments>(arguments)...) {}

    /// Throws std::runtime_error where a call is running.
    template <class Use>
    decltype(auto) use(Use&& with) {
        if (busy_.test_and_set()) throw std::runtime_error("another call is using this object");
        struct Release {
            std::atomic_flag& flag;
            ~Release() { flag.clear(); }
        } const release{busy_};
        return std::invoke(std::forward<Use>(with), value_);
    }

 private:
    Value value_;
    std::atomic_flag busy_;
};

/// What a method, or a function, makes of it, with the interpreter free.
template <class Value, class Method, class... Arguments>
auto used(Exclusive<Value>& object, Method method, const Arguments&... arguments) {
    return watched([&](Watch&) {
        return object.use([&](Value& value) { return std::invoke(method, value, arguments...); });
    });
}

/// The same for Python to call, with arguments of these types.
template <class Value, class... Arguments, class Method>
[[nodiscard]] auto locked(Method method) {
    return [method](Exclusive<Value>& object, const Arguments&... arguments) {
        return used(object, method, arguments...);
    };
}

}  // namespace signum::python
