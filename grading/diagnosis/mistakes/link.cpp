// What the linker could not find, or found twice.

#include "../../text/near_names.hpp"
#include "rules.hpp"

namespace contact::grading {

std::optional<Mistake> recognise_link(const LinkFaults& faults, const SourceText& source,
                                      const ContractText& contract) {
  const std::vector<FunctionDefinition>& defined = source.definitions();
  for (const std::string& symbol : faults.twice) {
    if (symbol == "main" || symbol.starts_with("__main") || symbol.starts_with("main("))
      return Mistake{"main-defined", "The tests bring their own main(): yours must go."};
    return Mistake{"defined-twice", "The tests or the book define " + function_name(symbol) +
                                        " too: give yours another name."};
  }
  for (const std::string& symbol : faults.missing) {
    const std::string name = function_name(symbol);
    if (name.empty() || name.front() == ' ') continue;
    const std::string qualified = symbol.substr(0, symbol.find('('));
    if (!contract.declared_by_contract(name))
      return Mistake{"undefined-function",
                     name + " is declared and called, but your file does not define it."};
    std::vector<std::string> others;
    for (const FunctionDefinition& other : defined) {
      if (other.qualified == qualified)
        return Mistake{
            "another-signature",
            "Your file defines " + other.written + ", whose parameters are not the contract's.",
            Place{other.line, 1}};
      if (other.name == name)
        return Mistake{
            "outside-namespace",
            "Your file defines " + other.qualified + ", which is not in namespace exercise.",
            Place{other.line, 1}};
      if (other.qualified.starts_with("exercise::") && !contract.declared_by_contract(other.name))
        others.push_back(other.name);
    }
    if (const std::vector<std::string> near = nearest(name, others); !near.empty()) {
      const auto meant =
          std::find_if(defined.begin(), defined.end(),
                       [&](const FunctionDefinition& other) { return other.name == near.front(); });
      return Mistake{"misspelt-function",
                     "Your file defines " + near.front() +
                         ", which the contract does not name: is it " + name + ", misspelt?",
                     Place{meant->line, 1}};
    }
    return Mistake{"function-missing",
                   "The contract asks for " + name + ", and your file does not define it."};
  }
  return std::nullopt;
}

}  // namespace contact::grading
