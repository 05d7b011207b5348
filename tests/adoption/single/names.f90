! The two files from Fortran: g++ -c signum_predicates.cpp && gfortran names.f90 signum_predicates.o -lstdc++
program names
  use iso_c_binding
  implicit none
  interface
    integer(c_int) function signum_ccw(a, b, c) bind(c)
      import
      real(c_double), intent(in) :: a(2), b(2), c(2)
    end function
  end interface
  real(c_double) :: a(2) = [0.1d0, 0.1d0], b(2) = [0.3d0, 0.3d0]
  print '(i0, 1x, i0)', signum_ccw(a, b, [0.7d0, 0.7d0]), signum_ccw(a, b, [0.2d0, 0.3d0])
end program
