//! The page of a picture: its title at the top, its legend at the foot, and what is drawn between.

use crate::legend::{Legend, Sign};
use crate::options::PictureOptions;
use crate::plot::{Plot, title};
use crate::scene::{Area, Dot, Item, Scene};

/// A page that is drawn on.
pub(crate) struct Page {
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// The size of letters.
    pub(crate) em: f64,
    /// Upper side of the legend.
    pub(crate) foot: f64,
    pub(crate) legend: Legend,
    pub(crate) items: Vec<Item>,
    title: String,
}

impl Page {
    /// A page for a picture that was designed for the size `usual`.
    pub(crate) fn of(
        options: &PictureOptions,
        usual: (f64, f64),
        entries: Vec<(Sign, String)>,
    ) -> Self {
        let (size, em) = options.sized(usual);
        let legend = Legend::new(entries, size.0 - 2.0 * em, em);
        Self::with(options, size, legend)
    }

    /// A page of a given size, with letters as large as those of its legend.
    pub(crate) fn with(
        options: &PictureOptions,
        (width, height): (f64, f64),
        legend: Legend,
    ) -> Self {
        let em = legend.em;
        let mut items = Vec::new();
        title(&mut items, &options.title, width, em);
        Self {
            width,
            height,
            em,
            foot: height - legend.height() - 0.5 * em,
            legend,
            items,
            title: options.title.clone(),
        }
    }

    /// Rectangle of the only plot of a picture, below the title and above the legend.
    pub(crate) fn area(&self) -> Area {
        let em = self.em;
        Area {
            lo: Dot::new(Plot::LEFT * em, 2.6 * em),
            hi: Dot::new(self.width - Plot::RIGHT * em, self.foot - Plot::BELOW * em),
        }
    }

    /// The picture, with its legend over all that was drawn.
    pub(crate) fn finished(mut self) -> Scene {
        let at = Dot::new(self.em, self.foot);
        self.legend.draw(&mut self.items, at);
        Scene {
            width: self.width,
            height: self.height,
            title: self.title,
            items: self.items,
        }
    }
}
