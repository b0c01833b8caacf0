#include "tests/support/program.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace scanway::test {
namespace {

void redirect(const char* path, int descriptor) {
  const int file = open(path, O_CREAT | O_WRONLY | O_APPEND, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
  close(file);
}

int status_of(int waited) { return WIFSIGNALED(waited) ? 128 + WTERMSIG(waited) : WEXITSTATUS(waited); }

}  // namespace

Program::Program(const std::vector<std::string>& words, const std::string& out, const std::string& err) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  child_ = fork();
  if (child_ != 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  redirect(out.c_str(), STDOUT_FILENO);
  redirect(err.c_str(), STDERR_FILENO);
  execvp(pointers[0], pointers.data());
  _exit(127);
}

Program::~Program() {
  if (runs()) end(SIGKILL);
}

bool Program::runs() {
  int waited = 0;
  if (status_ < 0 && waitpid(child_, &waited, WNOHANG) == child_) status_ = status_of(waited);
  return status_ < 0;
}

int Program::end(int signal) {
  if (!runs()) return status_;
  kill(child_, signal);
  int waited = 0;
  if (waitpid(child_, &waited, 0) == child_) status_ = status_of(waited);
  return status_;
}

}  // namespace scanway::test
