//! Reading the models, and asking for classes.

use cspace::{Classification, Configuration, ContactSpace, Options, Part, Vector};
use cspace_io::Model;

pub(crate) fn read(name: &str) -> (Part, Part) {
    let file = format!(
        "{}/../../models/paper/{name}.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let model = Model::read(file).unwrap();
    let pair = &model.pairs[0];
    let part = |index: usize| model.parts[index].part.clone();
    (part(pair.fixed), part(pair.moving))
}

#[test]
fn x(){ let (a,b)=read("cam"); let _=ContactSpace::compute(&a,&b,&Options::default()).unwrap(); let _=(Classification::Free, Configuration::new(0.,0.,0.),Vector::new(0.,0.)); }
