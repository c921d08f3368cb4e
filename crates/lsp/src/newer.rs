//! What newer clients say of themselves in places where the protocol library does not look: it is said again where it does.

use serde_json::{Map, Value, json};

/// What findings may hold. Clients that ask for findings may tell of it there alone.
const OF_FINDINGS: [&str; 3] = ["relatedInformation", "tagSupport", "codeDescriptionSupport"];

/// Mends the parameters of a greeting. Tells whether there was anything to mend.
pub(crate) fn say_again(greeting: &mut Value) -> bool {
    of_workspace(greeting) | of_findings(greeting)
}

/// The library looks for what clients say of findings in the workspace under another name than they give it.
fn of_workspace(greeting: &mut Value) -> bool {
    let workspace = greeting.pointer_mut("/capabilities/workspace");
    let Some(workspace) = workspace.and_then(Value::as_object_mut) else {
        return false;
    };
    let refreshes =
        workspace.get("diagnostics").and_then(|said| said.get("refreshSupport")) == Some(&Value::Bool(true));
    if refreshes {
        workspace.insert("diagnostic".to_owned(), json!({"refreshSupport": true}));
    }
    refreshes
}

fn of_findings(greeting: &mut Value) -> bool {
    let document = greeting.pointer_mut("/capabilities/textDocument");
    let Some(document) = document.and_then(Value::as_object_mut) else {
        return false;
    };
    let asked = document.get("diagnostic").and_then(Value::as_object);
    let can = |name: &&str| {
        let said = asked.and_then(|asked| asked.get(*name));
        // The support of tags has a list of them.
        said.is_some_and(|said| said.is_object() || said == &Value::Bool(true))
    };
    let can: Vec<&str> = OF_FINDINGS.into_iter().filter(can).collect();
    let sent = document.entry("publishDiagnostics").or_insert(Value::Null);
    if sent.is_null() {
        *sent = Map::new().into();
    }
    let Some(sent) = sent.as_object_mut() else {
        return false;
    };
    let mut mended = false;
    for name in can {
        let unsaid = sent
            .get(name)
            .is_none_or(|said| said.is_null() || said == &Value::Bool(false));
        if unsaid {
            sent.insert(name.to_owned(), Value::Bool(true));
            mended = true;
        }
    }
    mended
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::say_again;

    fn check(document: Value, sent: Value, mended: bool) {
        let mut greeting = json!({"capabilities": {"textDocument": document}});
        assert_eq!(say_again(&mut greeting), mended, "{document}");
        if mended {
            assert_eq!(
                greeting["capabilities"]["textDocument"]["publishDiagnostics"], sent,
                "{document}"
            );
        }
    }

    #[test]
    fn what_is_said_of_findings_that_are_asked_for_counts() {
        let all = json!({"relatedInformation": true, "tagSupport": {"valueSet": [1]}, "codeDescriptionSupport": true});
        let said = json!({"relatedInformation": true, "tagSupport": true, "codeDescriptionSupport": true});
        check(json!({"diagnostic": all}), said.clone(), true);
        check(json!({"diagnostic": all, "publishDiagnostics": null}), said, true);
        check(
            json!({"diagnostic": {"codeDescriptionSupport": true}, "publishDiagnostics": {"tagSupport": {"valueSet": [2]}}}),
            json!({"tagSupport": {"valueSet": [2]}, "codeDescriptionSupport": true}),
            true,
        );
        check(
            json!({"diagnostic": all, "publishDiagnostics": all}),
            json!(null),
            false,
        );
    }

    #[test]
    fn what_is_said_of_findings_in_the_workspace_counts() {
        for (said, mended) in [(json!(true), true), (json!(false), false), (json!(null), false)] {
            let mut greeting = json!({"capabilities": {"workspace": {"diagnostics": {"refreshSupport": said}}}});
            assert_eq!(say_again(&mut greeting), mended, "{said}");
            let heard = &greeting["capabilities"]["workspace"]["diagnostic"]["refreshSupport"];
            assert_eq!(heard == &json!(true), mended, "{said}");
        }
    }

    #[test]
    fn what_is_not_said_or_makes_no_sense_changes_nothing() {
        for document in [
            json!(null),
            json!({}),
            json!({"diagnostic": {}}),
            json!({"diagnostic": null}),
            json!({"diagnostic": {"codeDescriptionSupport": false, "tagSupport": 3}}),
            json!({"diagnostic": {"codeDescriptionSupport": true}, "publishDiagnostics": 5}),
        ] {
            check(document, json!(null), false);
        }
        assert!(!say_again(&mut json!({})));
        assert!(!say_again(&mut json!([1])));
    }
}
