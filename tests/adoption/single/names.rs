// The two files from Rust: g++ -c signum_predicates.cpp && rustc names.rs -C link-args="signum_predicates.o -lstdc++"
use std::os::raw::c_int;

extern "C" {
    fn signum_ccw(a: *const f64, b: *const f64, c: *const f64) -> c_int;
}

fn ccw(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> i32 {
    unsafe { signum_ccw(a.as_ptr(), b.as_ptr(), c.as_ptr()) }
}

fn main() {
    let (a, b) = ([0.1, 0.1], [0.3, 0.3]);
    println!("{} {}", ccw(a, b, [0.7, 0.7]), ccw(a, b, [0.2, 0.3]));
}
