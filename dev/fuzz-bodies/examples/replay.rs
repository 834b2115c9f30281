//! Runs a target on files, and says what it finds: `cargo run -p cspace-fuzz --example replay -- slice FILE …`
//!
//! A finding that has a pair is printed as a model file, what is wrong in comments above it.

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_default();
    let target = cspace_fuzz::target(&name).ok_or_else(|| {
        let names = cspace_fuzz::TARGETS.map(|t| t.name).join(", ");
        format!("say which of {names}, and then files")
    })?;
    for file in arguments {
        match (target.run)(&std::fs::read(&file)?) {
            Ok(judged) => eprintln!("{file}: nothing, {judged} answers judged"),
            Err(finding) => println!("# {file}\n{finding}"),
        }
    }
    Ok(())
}
