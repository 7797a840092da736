// The tolerance ledger: every declared gate with its bounds, one line each in a committed file, so that no bound
// changes unnoticed and none is widened without a date and a reason.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "cases/harness/compare/bounds.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/results/documents.hpp"

namespace plumbline {

struct Widening {
  Bounds from;
  std::string date, why;  // "2026-11-22"; neither empty
};

struct LedgerLine {
  std::string case_name, study, id;  // case "*": generic gates of every study
  std::string tier, origin;
  std::string reason;  // hash of the gate's reason and of the cause of its expected failure
  Bounds bounds;
  std::string since;  // of the bounds: date, and commit where they are a measurement of this program
  std::optional<Widening> widened;
  using Key = std::tuple<std::string, std::string, std::string>;
  Key key() const { return {case_name, study, id}; }
};

// The lines that gates declare, sorted; `date` is the `since` of those that carry no date of their own.
std::vector<LedgerLine> declared_lines(const std::vector<const Case*>& entries, const std::string& date);
LedgerLine declared_line(const std::string& case_name, const CaseGate& gate, const std::string& date);

// FileError for a file that is not there, is not a ledger, lists a gate twice or lacks date or reason of a widening.
std::vector<LedgerLine> read_ledger(const std::string& file);
// Whole or not at all; numbers with as many digits as it takes to read them back.
void write_ledger(const std::string& file, const std::vector<LedgerLine>& lines);

struct Discrepancy {
  std::string kind;  // widened, narrowed, reason, new, removed
  LedgerLine::Key gate;
  std::string message;
};

// Where the ledger does not say what is declared; the message tells old and new bounds and what to do about it.
std::vector<Discrepancy> discrepancies(const std::vector<LedgerLine>& recorded,
                                       const std::vector<LedgerLine>& declared);

// Lines of `recorded` that are wider than in `earlier`, another version of the ledger, and carry no new widening.
std::vector<Discrepancy> unsigned_widenings(const std::vector<LedgerLine>& earlier,
                                            const std::vector<LedgerLine>& recorded);

// The ledger brought up to what is declared. Gates that are wider than recorded get a widening of this date and reason;
// UsageError naming them if `why` is empty. A widening is kept for as long as its bounds are wider than those before.
std::vector<LedgerLine> updated(const std::vector<LedgerLine>& recorded, const std::vector<LedgerLine>& declared,
                                const std::string& why, const std::string& date);

Json to_json(const LedgerLine& line);

}  // namespace plumbline
