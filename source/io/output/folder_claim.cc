// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/output/folder_claim.h>

#include <cstdlib>
#include <filesystem>

namespace contrecoup
{
namespace io
{
  namespace
  {
    namespace fs = std::filesystem;

    /// A mistyped folder must not fill with results.
    void require_below(const std::string &folder)
    {
      std::error_code ignored;
      const char *home = std::getenv("HOME");
      for (const char *other : {"/", home})
        if (other != nullptr && fs::equivalent(folder, other, ignored))
          throw InputError(
            "the output folder \"" + folder + "\" is " +
            (other == home ? "your home folder" : "the root of all folders") +
            "; give one below it");
    }

    /// "a, b, c and 4 more".
    std::string list_text(const std::vector<std::string> &names)
    {
      constexpr std::size_t most = 3;
      if (names.size() <= most + 1)
        return join(names, ", ");
      return join({names.begin(), names.begin() + most}, ", ") + " and " +
             std::to_string(names.size() - most) + " more";
    }

    double size_of(const std::string &folder,
                   const std::vector<std::string> &files)
    {
      double size = 0.;
      std::error_code error;
      for (const std::string &file : files)
        if (const auto n = fs::file_size(folder + "/" + file, error); !error)
          size += static_cast<double>(n);
      return size;
    }

    /// Whether a folder holds no more than the lock of this run.
    bool is_empty(const std::string &folder)
    {
      std::error_code ignored;
      for (const auto &entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename() != FolderLock::name)
          return false;
      return true;
    }
  } // namespace

  FolderClaim::FolderClaim(const std::string &folder,
                           const std::string &application,
                           const FileNames &names,
                           const RunInput &input)
    : folder_(folder)
    , application_(application)
    , names_(names)
    , input_(input)
    , manifest_((make_folder(), folder))
  {
    try
    {
      lock_.emplace(folder, application);
      // Another run may have written the manifest before the lock was taken.
      manifest_ = Manifest(folder);
      require_own_names();
    }
    catch (const std::exception &)
    {
      discard();
      throw;
    }
  }

  FolderClaim::~FolderClaim()
  {
    discard();
  }

  void FolderClaim::make_folder()
  {
    require_below(folder_);
    std::error_code error;
    for (fs::path path = fs::path(folder_).lexically_normal();
         !path.empty() && path != path.root_path() &&
         !fs::exists(fs::symlink_status(path, error));
         path = path.parent_path())
      made_.push_back(path.string());
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_))
    {
      discard();
      throw InputError(
        "cannot make the output folder \"" + folder_ +
        "\": " + (error ? error.message() : "there is a file of this name"));
    }
  }

  void FolderClaim::require_own_names() const
  {
    const auto foreign = manifest_.foreign_files(names_);
    if (!foreign.empty())
      throw InputError("\"" + folder_ +
                       "\" holds files that no run of Contrecoup wrote and "
                       "this one would overwrite: " +
                       list_text(foreign) + "; give another --output");
  }

  std::string FolderClaim::difference() const
  {
    if (manifest_.application() != application_)
      return "it was one of \"" + manifest_.application() + "\"";
    return io::difference(manifest_.input(), input_);
  }

  bool FolderClaim::may_proceed(const CommandLine &command,
                                const std::function<bool()> &can_resume,
                                const std::string &more) const
  {
    if (!manifest_.exists() || command.overwrite || command.resume)
      return true;
    const std::string changed = difference();
    const std::string here = "\"" + folder_ + "\" holds ";
    const std::string ways =
      "; --overwrite replaces it, or give another --output";
    if (manifest_.status() == "finished")
    {
      if (!changed.empty())
        throw InputError(here + "the results of another run: " + changed +
                         ways);
      const std::string damage = manifest_.damage();
      if (!damage.empty())
        throw InputError(here + "this run, but " + damage +
                         "; --overwrite computes it anew");
      show_line("finished before, nothing is done: \"" + folder_ +
                "\" holds the results; " +
                (can_resume && can_resume()
                   ? "--resume goes on from there (with " + more + "), "
                   : "") +
                "--overwrite computes all anew");
      return false;
    }
    if (manifest_.application() != application_)
      throw InputError(here + "a run that has not finished: " + changed + ways);
    if (can_resume && can_resume())
      throw InputError(here + "a run that has not finished (" +
                       manifest_.status() +
                       "); --resume goes on with it, --overwrite begins anew");
    return true;
  }

  bool FolderClaim::goes_on(const CommandLine &command,
                            const bool can_resume) const
  {
    if (!command.resume)
      return false;
    const bool may_begin = manifest_.exists()
                             ? manifest_.application() == application_ &&
                                 manifest_.status() != "finished"
                             : is_empty(folder_);
    if (can_resume || !may_begin)
      return true;
    show_line("--resume: \"" + folder_ +
              "\" holds nothing to go on with yet; the run begins");
    return false;
  }

  void FolderClaim::begin()
  {
    const auto files = manifest_.own_files();
    if (!files.empty())
      show_line("removing what the earlier run (" + manifest_.application() +
                ", " + manifest_.status() + ") left in " + folder_ + ": " +
                std::to_string(files.size()) + " files, " +
                bytes(size_of(folder_, files)) + " (" + list_text(files) + ")");
    manifest_.begin(application_, names_, input_);
    made_.clear();
  }

  void FolderClaim::resume()
  {
    manifest_.resume(application_, names_, input_);
    made_.clear();
  }

  void FolderClaim::set_status(const std::string &status)
  {
    manifest_.set_status(status);
  }

  void FolderClaim::discard()
  {
    lock_.reset();
    std::error_code ignored;
    for (const std::string &folder : made_)
      fs::remove(folder, ignored);
    made_.clear();
  }
} // namespace io
} // namespace contrecoup
