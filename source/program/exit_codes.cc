// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/text.h>
#include <waker/program/exit_codes.h>

#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// In one piece: several ranks may have something to say.
    void
    print_lines(const std::string &where,
                const std::string &what,
                const std::string &allowed)
    {
      constexpr std::size_t longest = 1000;
      std::cerr << printable(where, longest) + "\n" + printable(what, longest) +
                     "\nallowed: " + printable(allowed, longest) + "\n"
                << std::flush;
    }


    int
    report_file_error(const std::string &path,
                      const std::string &what,
                      const bool         can_be_resumed)
    {
      print_lines(path,
                  what,
                  std::string("a writable folder with enough space; ") +
                    (can_be_resumed
                       ? "what is finished is kept, --resume goes on from there"
                       : "there is no checkpoint yet: --overwrite begins "
                         "anew"));
      return file_error;
    }


    int
    report_internal_error(const std::string &what)
    {
      std::cerr << "waker: internal error, please report it: " +
                     printable(what, 1000) + "\n"
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
        print_lines(error.where, error.problem, error.allowed);
        return wrong_input;
      }
    catch (const FileError &error)
      {
        return report_file_error(error.path,
                                 error.problem,
                                 error.can_be_resumed);
      }
    catch (const std::filesystem::filesystem_error &error)
      {
        return report_file_error(error.path1().string(),
                                 "cannot be used: " + error.code().message(),
                                 true);
      }
    catch (const NumericalFailure &error)
      {
        std::cerr << "numerical failure: " + printable(error.what(), 1000) +
                       "\n"
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
