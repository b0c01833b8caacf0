#include "common/files/saved_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>

#include "common/files/input_error.h"
#include "common/random/random.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

namespace fs = std::filesystem;

/// Three files, one of them in a folder below and of a name of its own; each says which save it is of.
void save(const std::string& folder, const std::string& which) {
  FolderSave save(folder);
  save.files().write("cloud", "cloud of " + which + std::string(50'000, '.'));
  save.files().write("grid", "grid of " + which);
  const ProductFolder below(save.files().path_of("sweeps"));
  below.write("sweep-" + which, "sweep of " + which);
  save.commit();
}

void expect_to_hold(const std::string& folder, const std::string& which) {
  const SavedFolder saved(folder);
  EXPECT_EQ(saved.digests().size(), 3U);
  EXPECT_EQ(read_text(saved.path_of("cloud")), "cloud of " + which + std::string(50'000, '.'));
  EXPECT_EQ(read_text(saved.path_of("grid")), "grid of " + which);
  EXPECT_EQ(read_text(saved.path_of("sweeps/sweep-" + which)), "sweep of " + which);
  const auto files = std::distance(fs::directory_iterator(folder + "/sweeps"), fs::directory_iterator());
  EXPECT_EQ(files, 1) << "what the older save had there is gone";
  EXPECT_FALSE(fs::exists(folder + "/.saving"));
}

std::string refusal(const std::string& folder) {
  try {
    const SavedFolder saved(folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(SavedFolder, HoldsTheNewestSaveAndLeavesOtherFilesAlone) {
  const ScratchFolder scratch;
  write_text(scratch / "notes.txt", "mine");
  for (const std::string which : {"first", "second", "third"}) {
    save(scratch.path(), which);
    expect_to_hold(scratch.path(), which);
  }
  EXPECT_EQ(read_text(scratch / "notes.txt"), "mine");
}

TEST(SavedFolder, WithoutCommitTheOldOneStays) {
  const ScratchFolder scratch;
  save(scratch.path(), "first");
  {
    const FolderSave given_up(scratch.path());
    given_up.files().write("grid", "half a grid");
  }
  expect_to_hold(scratch.path(), "first");
}

TEST(SavedFolder, NamesTheFileThatIsDamagedOrMissing) {
  const ScratchFolder scratch;
  save(scratch.path(), "first");
  for (const std::string name : {"cloud", "grid", "sweeps/sweep-first"}) {
    const std::string whole = read_text(scratch / name);
    std::string bad = whole;
    bad[bad.size() / 2] = static_cast<char>(bad[bad.size() / 2] ^ 1);
    write_text(scratch / name, bad);
    EXPECT_EQ(refusal(scratch.path()).find(scratch / name + ": is damaged"), 0U) << refusal(scratch.path());
    fs::remove(scratch / name);
    EXPECT_EQ(refusal(scratch.path()).find(scratch / name + ": is missing"), 0U) << refusal(scratch.path());
    write_text(scratch / name, whole);
  }
  expect_to_hold(scratch.path(), "first");
}

TEST(SavedFolder, RefusesAListThatIsNone) {
  const ScratchFolder scratch;
  EXPECT_NE(refusal(scratch.path()).find("is no saved map"), std::string::npos);
  for (const char* line :
       {"", "what is this\n", "XXH3 (../../etc/passwd) = 0123456789abcdef\n", "XXH3 (/etc/passwd) = 0123456789abcdef\n",
        "XXH3 (a) = 0123456789abcdeg\n", "XXH3 (a) = 0123\n", "XXH3 (.saving/a) = 0123456789abcdef\n"}) {
    write_text(scratch / "checksums.xxh3", line);
    EXPECT_NE(refusal(scratch.path()).find("checksums.xxh3"), std::string::npos) << line;
  }
}

TEST(SavedFolder, TwoCannotSaveAtOnce) {
  const ScratchFolder scratch;
  const FolderSave one(scratch.path());
  EXPECT_THROW(FolderSave other(scratch.path()), InputError);
}

/// As a save is left that was interrupted when its list was in place, and `moved` of its files.
void interrupt_save(const std::string& folder, const std::string& which, std::size_t moved) {
  const ScratchFolder elsewhere;
  save(elsewhere.path(), which);
  std::size_t number = 0;
  const SavedFolder saved(elsewhere.path());
  for (const auto& [name, digest] : saved.digests()) {
    const fs::path place = fs::path(number++ < moved ? folder : folder + "/.saving") / name;
    fs::create_directories(place.parent_path());
    fs::copy_file(elsewhere / name, place, fs::copy_options::overwrite_existing);
  }
  fs::create_directories(folder + "/.saving");
  fs::copy_file(elsewhere / "checksums.xxh3", folder + "/checksums.xxh3", fs::copy_options::overwrite_existing);
}

TEST(SavedFolder, IsTheNewOneOnceItsListIsInPlace) {
  for (std::size_t moved = 0; moved <= 3; ++moved) {
    for (const bool saves_next : {false, true}) {
      const ScratchFolder scratch;
      save(scratch.path(), "first");
      interrupt_save(scratch.path(), "second", moved);
      if (saves_next) FolderSave given_up(scratch.path());
      expect_to_hold(scratch.path(), "second");
    }
  }
}

useconds_t time_of_save(const std::string& folder, const std::string& which) {
  const auto begin = std::chrono::steady_clock::now();
  save(folder, which);
  const auto took = std::chrono::steady_clock::now() - begin;
  return static_cast<useconds_t>(std::chrono::duration_cast<std::chrono::microseconds>(took).count());
}

/// Saves `which` in a process that is killed after so many microseconds, if it is not done by then.
bool is_done_when_killed(const std::string& folder, const std::string& which, useconds_t after_us) {
  const pid_t child = fork();
  if (child == 0) {
    save(folder, which);
    _exit(0);
  }
  usleep(after_us);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status);
}

TEST(SavedFolder, IsOldOrNewWheneverTheSaverIsKilled) {
  const ScratchFolder scratch;
  Random random(7);
  std::string held = "0";
  const useconds_t whole_us = time_of_save(scratch.path(), held);
  int interrupted = 0, became_new = 0;
  for (int trial = 1; trial <= 60; ++trial) {
    const std::string next = std::to_string(trial);
    const bool done = is_done_when_killed(scratch.path(), next, static_cast<useconds_t>(random.below(whole_us)));
    const bool is_new = SavedFolder(scratch.path()).has("sweeps/sweep-" + next);
    EXPECT_TRUE(is_new || !done) << "trial " << trial;
    if (is_new) held = next;
    expect_to_hold(scratch.path(), held);
    if (!done) ++interrupted;
    if (!done && is_new) ++became_new;
  }
  std::printf("%d savers were killed at work; %d of them had their list in place\n", interrupted, became_new);
  EXPECT_GT(interrupted, 10);
}

}  // namespace
}  // namespace scanway::test
