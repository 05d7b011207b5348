! Textbook determinants in another language, under names of its own, as integers.
integer(c_int) function turn(a, b, c) bind(c)
  use iso_c_binding
  real(c_double), intent(in) :: a(2), b(2), c(2)
  real(c_double) :: value
  value = (a(1) - c(1)) * (b(2) - c(2)) - (a(2) - c(2)) * (b(1) - c(1))
  turn = merge(1, merge(-1, 0, value < 0), value > 0)
end function
