! Adapter for lubjoint verify: put your film force into `film` below, and run
!     gfortran -O2 film.f90 -o film && lubjoint verify --law LAW -- ./film
! As it stands it has the short bearing's full film, --law short_full. SI units throughout.
program adapter
  use, intrinsic :: iso_fortran_env, only: real64, int64
  implicit none
  integer, parameter :: dp = real64
  integer(int64) :: id
  integer :: status
  character(len=1024) :: line
  real(dp) :: viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy
  real(dp) :: e, x, y, rx, ry, eps_dot, gamma_dot, radial, tangential

  read (*, '(a)') line  ! the columns' names
  write (*, '(a)') 'id,fx,fy'
  do
    read (*, '(a)', iostat=status) line
    if (status /= 0) exit
    read (line, *) id, viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy
    e = hypot(ex, ey)
    ! At the centre r is the direction of the motion; at rest there any will do.
    x = merge(ex, vx, e > 0)
    y = merge(ey, vy, e > 0)
    rx = 1
    ry = 0
    if (hypot(x, y) > 0) then
      rx = x / hypot(x, y)
      ry = y / hypot(x, y)
    end if
    eps_dot = (vx * rx + vy * ry) / clearance
    gamma_dot = 0
    if (e > 0) gamma_dot = (vy * rx - vx * ry) / e
    call film(viscosity, length, radius, clearance, omega_bearing, omega_journal, e / clearance, eps_dot, gamma_dot, &
              radial, tangential)
    write (*, '(i0, ",", es25.16e3, ",", es25.16e3)') id, radial * rx - tangential * ry, radial * ry + tangential * rx
  end do

contains

  ! Radial and tangential force on the journal [N]: along r, from the bearing's centre to the journal's, and along t, r
  ! turned by 90 degrees counter-clockwise. eps = e/c, eps_dot its rate [1/s], gamma_dot the rate of the direction of r
  ! [rad/s] (0 where e = 0).
  subroutine film(viscosity, length, radius, clearance, omega_bearing, omega_journal, eps, eps_dot, gamma_dot, &
                  radial, tangential)
    real(dp), intent(in) :: viscosity, length, radius, clearance, omega_bearing, omega_journal, eps, eps_dot, gamma_dot
    real(dp), intent(out) :: radial, tangential
    ! ---- yours from here ----
    real(dp), parameter :: pi = 3.14159265358979323846_dp
    real(dp) :: a, q, scale
    a = eps * (omega_journal + omega_bearing - 2 * gamma_dot)
    q = (1 - eps) * (1 + eps)
    scale = viscosity * radius * length**3 / clearance**2
    radial = -scale * pi * eps_dot * (1 + 2 * eps * eps) / q**2.5_dp
    tangential = scale * pi * a / (2 * q**1.5_dp)
    ! ---- to here ----
  end subroutine film

end program adapter
