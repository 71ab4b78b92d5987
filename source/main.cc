// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/program/program.h>

int
main(int argc, char **argv)
{
  return Waker::run_program(argc, argv);
}
