// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/program/exit_codes.h>
#include <waker/program/prm_scanner.h>

#include <iostream>
#include <new>
#include <sstream>

namespace Waker
{
  namespace
  {
    int
    report_internal_error(const std::string &what)
    {
      std::cerr << "waker: internal error, please report it: " + tidy(what) +
                     "\n"
                << std::flush;
      return internal_error;
    }
  } // namespace


  int
  report_exception()
  {
    try
      {
        throw;
      }
    catch (const UserError &error)
      {
        // In one piece: several ranks may have something to say.
        std::cerr << tidy(error.where) + "\n" + tidy(error.problem) +
                       "\nallowed: " + tidy(error.allowed) + "\n"
                  << std::flush;
        return wrong_input;
      }
    catch (const NumericalFailure &error)
      {
        std::cerr << "numerical failure: " + tidy(error.what()) + "\n"
                  << std::flush;
        return numerical_failure;
      }
    catch (const std::bad_alloc &)
      {
        std::cerr << "waker: out of memory" << std::endl;
        return internal_error;
      }
    catch (const dealii::ExceptionBase &error)
      {
        std::ostringstream text;
        text << error.get_exc_name() << " ";
        error.print_info(text);
        return report_internal_error(text.str());
      }
    catch (const std::exception &error)
      {
        return report_internal_error(error.what());
      }
    catch (...)
      {
        return report_internal_error("unknown exception");
      }
  }
} // namespace Waker
