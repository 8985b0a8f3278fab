! SPDX-License-Identifier: GPL-3.0-or-later
! The judge of the deck reader: gfortran's own namelist reader on the groups of the thesis' decks and on $points.
!   gfortran -std=legacy -fcheck=all -o oracle oracle.f90
!   ./oracle < list-of-decks
! For each deck of the list (a path a line) it prints
!   DECK <path>
!   G <group> <iostat> <message>               0 read, -1 not there or not closed, else an error
!   V <group> <name>[(<i>[,<j>])] I <decimal>
!   V ...                         R <16 hexadecimal digits of the IEEE-754 double>
!   V ...                         L <T|F>
!   V ...                         S [<text without blanks at its end>]
! with a V line for every element that the deck sets. All start at sentinels, so that "not set" differs from "set to 0",
! and null values leave them in place. A logical has no sentinel: each deck is read twice, from .true. and .false.
! The unit is rewound before each group, so that groups may come in any order.
module deck_values
  use, intrinsic :: iso_fortran_env, only: real64, int32, int64
  implicit none
  integer, parameter :: dp = real64
  integer, parameter :: nr = 20, nv = 20, no = 60  ! regions, vertices of a region, outputs
  integer, parameter :: np = 1000                  ! points; the program has more, which would only cost time here
  integer, parameter :: nt = 100                   ! places that are tracked
  integer(int32), parameter :: no_integer = -2147483647
  integer(int64), parameter :: no_real_bits = int(z'7FF8DEADBEEF0001', int64)  ! a quiet NaN with a payload
  real(dp), parameter :: no_real = transfer(no_real_bits, 1.0_dp)
  character(1), parameter :: no_text = achar(1)
  character(6), parameter :: groups(5) = [character(6) :: 'in', 'fluid', 'regrig', 'reg', 'points']

  integer :: nx, ny, iprint, igen, miter, wl, wr, wb, wt, methd, iout(no)
  real(dp) :: gravc, xleft, xright, ybot, ytop, cntr, tmax, tstep, dtmax, tplt, tol, cyl, tiout(no)
  logical :: large, large_1
  character(40) :: particles
  real(dp) :: mu, gm1, siep(nr), lambda, coef1, coef2
  integer :: nregrig
  integer :: nreg, nvi(nr), nprg(nr), ipath(4, nr)
  real(dp) :: xvi(nv, nr), yvi(nv, nr), xcenter(nr), ycenter(nr), rix(nr), rex(nr), riy(nr), rey(nr)
  real(dp) :: densir(nr), matr(nr, nr), vrx(nr), vry(nr)
  real(dp) :: heavy(np), tracked_at(2, nt)
  logical :: tracked(np), tracked_1(np)

  namelist /in/ nx, ny, iprint, igen, gravc, xleft, xright, ybot, ytop, cntr, tmax, tstep, dtmax, tplt, tol, miter, &
    large, wl, wr, wb, wt, iout, tiout, methd, cyl, particles
  namelist /fluid/ mu, gm1, siep, lambda, coef1, coef2
  namelist /regrig/ nregrig
  namelist /reg/ nreg, nvi, xvi, yvi, xcenter, ycenter, rix, rex, riy, rey, nprg, densir, matr, ipath, vrx, vry
  namelist /points/ heavy, tracked, tracked_at

  interface show
    procedure show_integer, show_integers, show_integer_matrix, show_real, show_reals, show_real_matrix
  end interface

contains

  subroutine reset(start)
    logical, intent(in) :: start
    nx = no_integer; ny = nx; iprint = nx; igen = nx; miter = nx; wl = nx; wr = nx; wb = nx; wt = nx; methd = nx
    iout = nx; nregrig = nx; nreg = nx; nvi = nx; nprg = nx; ipath = nx
    gravc = no_real; xleft = gravc; xright = gravc; ybot = gravc; ytop = gravc; cntr = gravc; tmax = gravc
    tstep = gravc; dtmax = gravc; tplt = gravc; tol = gravc; cyl = gravc; tiout = gravc
    mu = gravc; gm1 = gravc; siep = gravc; lambda = gravc; coef1 = gravc; coef2 = gravc
    xvi = gravc; yvi = gravc; xcenter = gravc; ycenter = gravc; rix = gravc; rex = gravc; riy = gravc; rey = gravc
    densir = gravc; matr = gravc; vrx = gravc; vry = gravc
    heavy = gravc; tracked_at = gravc
    large = start; tracked = start
    particles = repeat(no_text, len(particles))
  end subroutine

  ! Reads all groups of a deck; states and messages are their iostat and iomsg.
  subroutine read_groups(path, states, messages)
    character(*), intent(in) :: path
    integer, intent(out) :: states(size(groups))
    character(*), intent(out) :: messages(size(groups))
    integer :: unit
    messages = ' '
    open(newunit=unit, file=path, status='old', action='read')
    read(unit, nml=in, iostat=states(1), iomsg=messages(1))
    rewind(unit)
    read(unit, nml=fluid, iostat=states(2), iomsg=messages(2))
    rewind(unit)
    read(unit, nml=regrig, iostat=states(3), iomsg=messages(3))
    rewind(unit)
    read(unit, nml=reg, iostat=states(4), iomsg=messages(4))
    rewind(unit)
    read(unit, nml=points, iostat=states(5), iomsg=messages(5))
    close(unit)
  end subroutine

  subroutine show_deck(path)
    character(*), intent(in) :: path
    integer :: states(size(groups)), k
    character(200) :: messages(size(groups))
    call reset(.true.)
    call read_groups(path, states, messages)
    large_1 = large
    tracked_1 = tracked
    call reset(.false.)
    call read_groups(path, states, messages)
    print '(2a)', 'DECK ', path
    print '(3a,i0,2a)', ('G ', trim(groups(k)), ' ', states(k), ' ', trim(messages(k)), k = 1, size(groups))
    call show_in
    call show_fluid
    call show_regions
    call show_points
  end subroutine

  subroutine show_in
    call show('in nx', nx); call show('in ny', ny); call show('in iprint', iprint); call show('in igen', igen)
    call show('in gravc', gravc); call show('in xleft', xleft); call show('in xright', xright)
    call show('in ybot', ybot); call show('in ytop', ytop); call show('in cntr', cntr); call show('in tmax', tmax)
    call show('in tstep', tstep); call show('in dtmax', dtmax); call show('in tplt', tplt); call show('in tol', tol)
    call show('in miter', miter); call show_logical('in large', large, large_1)
    call show('in wl', wl); call show('in wr', wr); call show('in wb', wb); call show('in wt', wt)
    call show('in iout', iout); call show('in tiout', tiout); call show('in methd', methd); call show('in cyl', cyl)
    if (particles(1:1) /= no_text) print '(3a)', 'V in particles S [', trim(particles), ']'
  end subroutine

  subroutine show_fluid
    call show('fluid mu', mu); call show('fluid gm1', gm1); call show('fluid siep', siep)
    call show('fluid lambda', lambda); call show('fluid coef1', coef1); call show('fluid coef2', coef2)
  end subroutine

  subroutine show_regions
    call show('regrig nregrig', nregrig)
    call show('reg nreg', nreg); call show('reg nvi', nvi); call show('reg xvi', xvi); call show('reg yvi', yvi)
    call show('reg xcenter', xcenter); call show('reg ycenter', ycenter); call show('reg rix', rix)
    call show('reg rex', rex); call show('reg riy', riy); call show('reg rey', rey); call show('reg nprg', nprg)
    call show('reg densir', densir); call show('reg matr', matr); call show('reg ipath', ipath)
    call show('reg vrx', vrx); call show('reg vry', vry)
  end subroutine

  subroutine show_points
    integer :: i
    call show('points heavy', heavy)
    do i = 1, np
      if (tracked(i) .eqv. tracked_1(i)) call show_logical(element('points tracked', i), tracked(i), tracked_1(i))
    end do
    call show('points tracked_at', tracked_at)
  end subroutine

  subroutine show_logical(name, from_false, from_true)
    character(*), intent(in) :: name
    logical, intent(in) :: from_false, from_true
    if (from_false .eqv. from_true) print '(3a,l1)', 'V ', trim(name), ' L ', from_false
  end subroutine

  subroutine show_integer(name, value)
    character(*), intent(in) :: name
    integer, intent(in) :: value
    if (value /= no_integer) print '(3a,i0)', 'V ', trim(name), ' I ', value
  end subroutine

  logical function is_set(value)
    real(dp), intent(in) :: value
    is_set = transfer(value, 0_int64) /= no_real_bits
  end function

  subroutine show_real(name, value)
    character(*), intent(in) :: name
    real(dp), intent(in) :: value
    if (is_set(value)) print '(3a,z16.16)', 'V ', trim(name), ' R ', transfer(value, 0_int64)
  end subroutine

  function element(name, i, j) result(text)
    character(*), intent(in) :: name
    integer, intent(in) :: i
    integer, intent(in), optional :: j
    character(40) :: text
    if (present(j)) then
      write(text, '(a,"(",i0,",",i0,")")') name, i, j
    else
      write(text, '(a,"(",i0,")")') name, i
    end if
  end function

  subroutine show_integers(name, values)
    character(*), intent(in) :: name
    integer, intent(in) :: values(:)
    integer :: i
    do i = 1, size(values)
      if (values(i) /= no_integer) call show(element(name, i), values(i))
    end do
  end subroutine

  subroutine show_reals(name, values)
    character(*), intent(in) :: name
    real(dp), intent(in) :: values(:)
    integer :: i
    do i = 1, size(values)
      if (is_set(values(i))) call show(element(name, i), values(i))
    end do
  end subroutine

  subroutine show_integer_matrix(name, values)
    character(*), intent(in) :: name
    integer, intent(in) :: values(:, :)
    integer :: i, j
    do j = 1, size(values, 2)
      do i = 1, size(values, 1)
        if (values(i, j) /= no_integer) call show(element(name, i, j), values(i, j))
      end do
    end do
  end subroutine

  subroutine show_real_matrix(name, values)
    character(*), intent(in) :: name
    real(dp), intent(in) :: values(:, :)
    integer :: i, j
    do j = 1, size(values, 2)
      do i = 1, size(values, 1)
        if (is_set(values(i, j))) call show(element(name, i, j), values(i, j))
      end do
    end do
  end subroutine
end module

program oracle
  use deck_values
  implicit none
  character(1000) :: path
  integer :: state
  do
    read(*, '(a)', iostat=state) path
    if (state /= 0) exit
    call show_deck(trim(path))
  end do
end program
