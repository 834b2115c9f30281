//! debug
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let p = cspace_oracle::pair(&name);
    println!("{:?}\n{:?}", p.fixed, p.moving);
    let s =
        cspace::ContactSpace::compute(&p.fixed, &p.moving, &cspace::Options::default()).unwrap();
    println!("{:#?}", s.statistics());
    println!(
        "crit {} patches {} side {} vert {} regions {:?}",
        s.critical_orientations().len(),
        s.patches().len(),
        s.side_links().len(),
        s.vertical_links().len(),
        s.free_regions()
    );
}
