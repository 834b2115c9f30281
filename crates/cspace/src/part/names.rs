//! Names of edges and vertices.

use super::{Part, PartError, PartFeature};

impl Part {
    /// The part with a name for one of its edges or vertices, which is used in texts.
    ///
    /// # Errors
    /// If the part has no such edge or vertex, or the name is empty or that of another.
    ///
    /// ```
    /// use cspace::part::{Part, PartFeature};
    /// let floor = PartFeature::Edge { loop_index: 0, index: 2 };
    /// let tray = Part::rectangle("tray", (0.0, 0.0), 4.0, 2.0)?.with_feature_name(floor, "top")?;
    /// assert_eq!(tray.feature_name(floor), Some("top"));
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn with_feature_name(
        mut self,
        feature: PartFeature,
        name: impl Into<String>,
    ) -> Result<Self, PartError> {
        let name = name.into();
        let (PartFeature::Edge { loop_index, index } | PartFeature::Vertex { loop_index, index }) =
            feature;
        let vertices = self
            .loops()
            .get(loop_index as usize)
            .map(|l| l.vertices().len());
        if vertices.is_none_or(|n| index as usize >= n) {
            return Err(PartError::NoFeature { feature });
        }
        let other = self.names.iter().find(|n| n.1 == name && n.0 != feature);
        if name.trim().is_empty() || other.is_some() {
            return Err(PartError::FeatureName { feature, name });
        }
        match self.names.binary_search_by_key(&feature, |n| n.0) {
            Ok(at) => self.names[at].1 = name,
            Err(at) => self.names.insert(at, (feature, name)),
        }
        Ok(self)
    }

    /// The name of an edge or a vertex, if it has one.
    pub fn feature_name(&self, feature: PartFeature) -> Option<&str> {
        let at = self.names.binary_search_by_key(&feature, |n| n.0).ok()?;
        Some(&self.names[at].1)
    }

    /// All names of edges and vertices.
    pub fn feature_names(&self) -> impl Iterator<Item = (PartFeature, &str)> {
        self.names
            .iter()
            .map(|(feature, name)| (*feature, name.as_str()))
    }
}
